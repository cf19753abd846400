// What comes out of an input is finite and in range, whatever a texture or a scene holds: a number
// that is not one counts as the lower limit.

#pragma once

#include "base/vector.h"

#include <algorithm>

namespace eye_render {

[[nodiscard]] inline float in_range(float value, float minimum, float maximum)
{
    return value > minimum ? std::min(value, maximum) : minimum;
}

[[nodiscard]] inline float unit_range(float value) { return in_range(value, 0.0f, 1.0f); }

// Not negative, and small enough for products of a few to stay finite.
[[nodiscard]] inline float positive_range(float value)
{
    constexpr float largest = 1e8f;
    return in_range(value, 0.0f, largest);
}

[[nodiscard]] inline Color3f positive_range(const Color3f& c)
{
    return {positive_range(c.x), positive_range(c.y), positive_range(c.z)};
}

[[nodiscard]] inline Color3f unit_range(const Color3f& c)
{
    return {unit_range(c.x), unit_range(c.y), unit_range(c.z)};
}

// Blender's limits of an index of refraction.
inline constexpr float largest_ior = 1000.0f;
[[nodiscard]] inline float ior_range(float ior) { return in_range(ior, 1e-5f, largest_ior); }

}  // namespace eye_render
