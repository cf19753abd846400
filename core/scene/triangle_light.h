// A triangle that shines, seen from a point that it may light: sampled by solid angle where it is
// large or near, which leaves nothing but the cosine at the point to vary, and by area elsewhere.

#pragma once

#include "scene/spherical_triangle.h"

#include <array>
#include <optional>

namespace eye_render {

class TriangleLight {
public:
    TriangleLight(const std::array<V3f, 3>& corners_world, const V3f& p_world);

    // Weights of the second and the third corner, u in [0, 1)^2.
    [[nodiscard]] V2f sample(const V2f& u) const;
    // Density, per unit solid angle, of the sample that lies so from the point; 0 for a triangle
    // that is seen edge-on.
    [[nodiscard]] float pdf(const V3f& to_light) const;

private:
    V3f to_first_;
    V3f edge1_;
    V3f edge2_;
    V3f normal_;                               // as long as twice the area
    std::optional<SphericalTriangle> sphere_;  // nothing: by area
};

}  // namespace eye_render
