// Where a bevel looks for the surfaces around a hit, after King et al. 2013, "BSSRDF Importance
// Sampling" (SIGGRAPH talks): short rays through a ball around the hit, square to a disk that
// stands along the normal or across it, so that walls are found as well as floors.
//
// The disk's points, and the surfaces found, count by the cubic fall-off 10 (R - r)^3 / (pi R^5)
// of their distance r from the hit: per unit area, 1 over the disk, 0 from the radius R on.

#pragma once

#include "base/vector.h"

#include <array>

namespace eye_render {

[[nodiscard]] float bevel_falloff(float distance, float radius);

// The distance r, of a radius of 1, within which the share `u` in [0, 1) of the fall-off lies.
[[nodiscard]] float sample_bevel_distance(float u);

struct BevelRay {
    V3f start;  // from the hit, world
    V3f direction;
    float length = 0.0f;
    float disk_pdf = 0.0f;             // per unit area of the disk
    std::array<V3f, 3> axes;           // of the disk, first the one that the ray runs along
    std::array<float, 3> axis_shares;  // how often each of them is the first
};

// `u_axis` and both of `u` in [0, 1).
[[nodiscard]] BevelRay sample_bevel_ray(const V3f& ng, float radius, float u_axis, const V2f& u);

// What a surface of geometric normal `ng` counts that such a ray meets at `distance` from the hit:
// the fall-off over the density of all axes by which it can be found, by the power heuristic.
[[nodiscard]] float bevel_weight(const BevelRay& ray, float radius, const V3f& ng, float distance);

}  // namespace eye_render
