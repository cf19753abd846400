// Cryptomatte's pictures: the things that cover a pixel, those that cover most of it first, two a
// picture as (id, coverage, id, coverage). Friedman & Jones 2015.

#pragma once

#include "render/pass_values.h"

#include <span>
#include <vector>

namespace eye_render {

// What the samples of one pixel met, each thing once, in the order of their meeting.
class MatteSums {
public:
    void add(float id, double weight);

    // Writes the two things of picture `number`; zero where there are no more. `whole` is the
    // weight of all samples.
    void write(std::size_t number, double whole, std::span<float, 4> pixel) const;

private:
    struct Sum {
        float id = 0.0f;
        double weight = 0.0;
    };
    std::vector<Sum> sums_;
};

}  // namespace eye_render
