// How surfaces around a hit are looked for, after King et al. 2013, "BSSRDF Importance Sampling"
// (SIGGRAPH talks): short rays through a ball around the hit, square to a disk that stands along
// the normal or across it, so that walls are found as well as floors.

#pragma once

#include "base/vector.h"

#include <array>

namespace eye_render {

struct DiskRay {
    V3f start;  // from the hit, world
    V3f direction;
    float length = 0.0f;
    std::array<V3f, 3> axes;           // of the disk, first the one that the ray runs along
    std::array<float, 3> axis_shares;  // how often each of them is the first
};

// Through a ball of that radius, at `distance` from its middle. Both of `u` in [0, 1).
[[nodiscard]] DiskRay make_disk_ray(const V3f& ng,
                                    float distance,
                                    float radius,
                                    float u_axis,
                                    float u_around);

// Against the density of the ray in its disk, what a surface of geometric normal `ng` counts that
// the ray meets: one over the density of all axes by which it can be found, by the power
// heuristic.
[[nodiscard]] float axis_weight(const DiskRay& ray, const V3f& ng);

}  // namespace eye_render
