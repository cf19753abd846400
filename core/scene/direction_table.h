// Directions drawn by a piecewise constant table of luminance over longitude and latitude, times
// solid angle (Pharr, Jakob and Humphreys, Physically Based Rendering, 12.5). Directions are unit;
// probabilities are per unit solid angle.

#pragma once

#include "base/vector.h"

#include <functional>
#include <vector>

namespace eye_render {

class DirectionTable {
public:
    DirectionTable() = default;  // empty
    // Half as high as wide. `luminance` is asked `looks` times along either side of a cell, from
    // several threads.
    DirectionTable(int width, int looks, const std::function<float(const V3f&)>& luminance);

    [[nodiscard]] bool empty() const { return row_cdf_.empty(); }
    // Of what was asked, averaged over the sphere.
    [[nodiscard]] float mean_luminance() const { return mean_luminance_; }

    struct Sample {
        V3f direction;
        float pdf = 0.0f;
    };
    // u in [0,1)^2. Not of an empty table, as is the density.
    [[nodiscard]] Sample sample(const V2f& u) const;
    // Positive everywhere.
    [[nodiscard]] float pdf(const V3f& direction) const;

private:
    [[nodiscard]] float density(float cell_probability, float z_extent) const;

    float mean_luminance_ = 0.0f;
    int width_ = 0;
    int height_ = 0;
    // Cumulative probability: of each row; and within each row, of each cell. Both start at 0.
    std::vector<float> row_cdf_;
    std::vector<float> cell_cdf_;
};

}  // namespace eye_render
