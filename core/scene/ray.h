// A ray in world space: float, with the eye at the origin of world space.

#pragma once

#include "base/vector.h"
#include "scene/motion.h"

#include <cstdint>
#include <limits>

namespace eye_render {

// A placement is met by the rays whose mask shares a bit with its own.
using RayMask = std::uint32_t;
inline constexpr RayMask all_rays = ~RayMask{0};

// Part of a placement of strands: its segments from `first` on and before `end`.
struct StrandSegments {
    std::uint32_t placement = 0;
    std::uint32_t first = 0;
    std::uint32_t end = 0;
};

struct Ray {
    V3f origin{0.0f};
    V3f direction{0.0f, 0.0f, -1.0f};  // unit
    float t_min = 0.0f;
    float t_max = std::numeric_limits<float>::infinity();
    float time = shutter_middle;  // from 0 to 1 while the shutter is open
    // The strand that the ray leaves, if any, which it does not meet: as in Cycles, no strand is
    // in its own shadow.
    StrandSegments left{};
};

// Moves a surface point off its surface to the side of the unit normal `n`: by `error`, how far
// from the surface the point itself may lie, and by the spacing of floats at the point's largest
// coordinate. Both scale with the scene: walls a hundred-thousandth of their distance apart do not
// leak, in kilometres and in millimetres.
[[nodiscard]] V3f offset_from_surface(const V3f& p, const V3f& n, float error);

}  // namespace eye_render
