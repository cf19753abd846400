// Numbers from outside, made safe to calculate with: node inputs may be NaN, infinite or huge.

#pragma once

#include "base/vector.h"
#include "shading/input_range.h"

#include <cmath>
#include <limits>

namespace eye_render {

// NaN and the infinities become 0.
[[nodiscard]] inline float finite(float x) { return std::isfinite(x) ? x : 0.0f; }
[[nodiscard]] inline V3f finite(const V3f& v) { return {finite(v.x), finite(v.y), finite(v.z)}; }

// The largest integer not above x; the least of all integers for NaN and what does not fit, as
// x86 processors convert it, so that patterns continue far away as Blender's.
[[nodiscard]] inline int floor_to_int(float x)
{
    constexpr float limit = 2147483648.0f;  // 2^31, the first that does not fit
    const float floored = std::floor(x);
    return floored >= -limit && floored < limit ? static_cast<int>(floored)
                                                : std::numeric_limits<int>::min();
}

// Blender's linear blend; exact at both ends.
[[nodiscard]] inline float blend(float a, float b, float t) { return (1.0f - t) * a + t * b; }
[[nodiscard]] inline V3f blend(const V3f& a, const V3f& b, float t)
{
    return (1.0f - t) * a + t * b;
}

// 3t^2 - 2t^3 between 0 and 1, constant outside; NaN becomes 0.
[[nodiscard]] inline float smooth_step(float t)
{
    const float x = unit_range(t);
    return x * x * (3.0f - 2.0f * x);
}

}  // namespace eye_render
