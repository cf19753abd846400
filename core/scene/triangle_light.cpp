#include "scene/triangle_light.h"

#include "base/warp.h"

namespace eye_render {

namespace {

// Below it the roundings of three unit vectors, 1e-7, count; such a triangle is nearly edge-on.
constexpr float least_solid_angle = 1e-3f;

}  // namespace

TriangleLight::TriangleLight(const std::array<V3f, 3>& corners_world, const V3f& p_world)
    : to_first_(corners_world[0] - p_world), edge1_(corners_world[1] - corners_world[0]),
      edge2_(corners_world[2] - corners_world[0]), normal_(edge1_.cross(edge2_))
{
    const float longest2 = std::max(
        {edge1_.length2(), edge2_.length2(), (corners_world[2] - corners_world[1]).length2()});
    // Of the triangle's plane from the point, times the normal's length.
    const float distance = normal_.dot(to_first_);
    if (distance * distance < longest2 * normal_.length2()) {
        const SphericalTriangle sphere(to_first_, to_first_ + edge1_, to_first_ + edge2_);
        if (sphere.solid_angle() > least_solid_angle) {
            sphere_ = sphere;
        }
    }
}

V2f TriangleLight::sample(const V2f& u) const
{
    if (!sphere_) {
        const V2f first_and_second = sample_uniform_triangle(u);
        return {first_and_second.y, 1.0f - first_and_second.x - first_and_second.y};
    }
    const V3f direction = sphere_->sample(u);
    const float distance = normal_.dot(to_first_) / normal_.dot(direction);
    const V3f from_first = direction * distance - to_first_;
    const float area2 = normal_.length2();
    // Rounding may leave the edges.
    const float v = std::clamp(from_first.cross(edge2_).dot(normal_) / area2, 0.0f, 1.0f);
    const float w = std::clamp(edge1_.cross(from_first).dot(normal_) / area2, 0.0f, 1.0f - v);
    return {v, w};
}

float TriangleLight::pdf(const V3f& to_light) const
{
    if (sphere_) {
        return 1.0f / sphere_->solid_angle();
    }
    // |2 area normal . to_light|
    const float projected = std::abs(normal_.dot(to_light));
    const float distance2 = to_light.length2();
    return projected > 0.0f ? uniform_triangle_pdf() * distance2 * std::sqrt(distance2) / projected
                            : 0.0f;
}

}  // namespace eye_render
