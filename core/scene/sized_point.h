// A point with a radius, laid out as four floats: a key of a strand, or a ball.

#pragma once

#include "base/vector.h"

#include <cmath>

namespace eye_render {

struct SizedPoint {
    V3f center{0.0f};
    float radius = 0.0f;

    [[nodiscard]] SizedPoint operator*(float factor) const
    {
        return {center * factor, radius * factor};
    }
    [[nodiscard]] SizedPoint operator+(const SizedPoint& other) const
    {
        return {center + other.center, radius + other.radius};
    }
    [[nodiscard]] bool is_finite() const
    {
        return std::isfinite(center.x + center.y + center.z + radius);
    }
};

static_assert(sizeof(SizedPoint) == 4 * sizeof(float));

}  // namespace eye_render
