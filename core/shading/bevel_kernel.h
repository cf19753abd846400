// Where a bevel looks for the surfaces around a hit: along disk rays.
//
// The disk's points, and the surfaces found, count by the cubic fall-off 10 (R - r)^3 / (pi R^5)
// of their distance r from the hit: per unit area, 1 over the disk, 0 from the radius R on.

#pragma once

#include "shading/disk_ray.h"

namespace eye_render {

[[nodiscard]] float bevel_falloff(float distance, float radius);

// The distance r, of a radius of 1, within which the share `u` in [0, 1) of the fall-off lies.
[[nodiscard]] float sample_bevel_distance(float u);

struct BevelRay {
    DiskRay ray;
    float disk_pdf = 0.0f;  // per unit area of the disk
};

// `u_axis` and both of `u` in [0, 1).
[[nodiscard]] BevelRay sample_bevel_ray(const V3f& ng, float radius, float u_axis, const V2f& u);

// What a surface of geometric normal `ng` counts that such a ray meets at `distance` from the hit:
// the fall-off over the density of all axes by which it can be found.
[[nodiscard]] float bevel_weight(const BevelRay& bevel,
                                 float radius,
                                 const V3f& ng,
                                 float distance);

}  // namespace eye_render
