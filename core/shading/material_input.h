// Reading the inputs of a material at a hit. Whatever a texture or a scene holds, what comes out
// is finite and in range: a number that is not one counts as the lower limit.

#pragma once

#include "shading/material.h"

namespace eye_render {

[[nodiscard]] inline float clamp_to(float value, float minimum, float maximum)
{
    return value > minimum ? std::min(value, maximum) : minimum;
}

// Not negative, and small enough for products of a few to stay finite.
[[nodiscard]] inline Color3f radiance_range(const Color3f& c)
{
    constexpr float largest = 1e8f;
    return {clamp_to(c.x, 0.0f, largest), clamp_to(c.y, 0.0f, largest),
            clamp_to(c.z, 0.0f, largest)};
}

// What a texture or an attribute gives, unclamped. The input is not constant.
[[nodiscard]] Color4f look_up(const MaterialInput& input, const HitAttributes& attributes);
[[nodiscard]] Color3f color_from_lookup(const MaterialInput& input, const Color4f& c);
[[nodiscard]] float scalar_from_lookup(const MaterialInput& input, const Color4f& c);

[[nodiscard]] inline Color3f read_color(const MaterialInput& input,
                                        const HitAttributes& attributes)
{
    return radiance_range(input.is_constant()
                              ? input.constant
                              : color_from_lookup(input, look_up(input, attributes)));
}

[[nodiscard]] inline float read_scalar(const MaterialInput& input,
                                       const HitAttributes& attributes,
                                       float minimum,
                                       float maximum)
{
    return clamp_to(input.is_constant() ? input.constant.x
                                        : scalar_from_lookup(input, look_up(input, attributes)),
                    minimum, maximum);
}

// Blender's limits.
[[nodiscard]] inline float read_ior(const MaterialInput& input, const HitAttributes& attributes)
{
    return read_scalar(input, attributes, 1e-5f, 1000.0f);
}

}  // namespace eye_render
