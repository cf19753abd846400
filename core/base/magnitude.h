// Light of lamps and emission may be negative: it takes away from other light, as in Cycles. What
// is chosen, clamped or left out by how strong a light is goes by this.

#pragma once

#include "base/vector.h"

#include <cmath>

namespace eye_render {

[[nodiscard]] inline Color3f magnitude(const Color3f& light)
{
    return {std::abs(light.x), std::abs(light.y), std::abs(light.z)};
}

// False for NaN, too.
[[nodiscard]] inline bool is_light(const Color3f& light)
{
    return max_component(magnitude(light)) > 0.0f;
}

}  // namespace eye_render
