// How the shutter opens and closes: when paths see the scene, as a density over time from 0, when
// it begins to open, to 1, when it is closed.

#pragma once

#include <vector>

namespace eye_render {

class Shutter {
public:
    // How far it is open at equally spaced times from 0 to 1, straight between them. Throws
    // std::invalid_argument for fewer than two, one that is negative or not finite, or none that
    // is positive.
    explicit Shutter(const std::vector<double>& openness);

    // u in [0, 1).
    [[nodiscard]] float sample(float u) const;
    // Per unit of that time.
    [[nodiscard]] double pdf(double time) const;

private:
    std::vector<double> density_;
    std::vector<double> closed_before_;  // the integral of the density up to each of the times
};

}  // namespace eye_render
