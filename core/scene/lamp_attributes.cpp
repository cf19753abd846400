#include "scene/lamp_attributes.h"

#include "scene/transform.h"
#include "shading/object_space.h"
#include "shading/picture_coordinates.h"

#include <cmath>

namespace eye_render {

LampSpace::LampSpace(const M44d& world_from_light, bool has_own_space)
    : is_of_object(has_own_space)
{
    M44d matrix = world_from_light;
    if (!is_of_object) {
        matrix[3][0] = matrix[3][1] = matrix[3][2] = 0.0;
    }
    facts = {.world_from_object = to_float(matrix),
             .object_from_world = to_float(matrix.inverse()),
             .color = Color4f(0.0f)};
}

ShadingPoint LampAttributes::shading_point() const
{
    const V3f normal = smooth_normal();
    return {.wo = -sight_.wi, .ng = normal, .ns = normal};
}

V3f LampAttributes::position_world() const
{
    if (lamp_.kind == LampKind::Sun) {
        return -sight_.wi;  // it has no place: Cycles' choice
    }
    return {V3d(lamp_.position + to_place()) + frame_.eye_position_world};
}

V3f LampAttributes::position_object() const
{
    return space_.is_of_object ? position_world() * facts_.object_from_world : position_world();
}

V3f LampAttributes::smooth_normal() const
{
    if (lamp_.kind == LampKind::Area) {
        return -lamp_.axis_z;
    }
    return lamp_.is_sphere && !lamp_.is_delta ? unit_or(to_place(), -sight_.wi) : -sight_.wi;
}

V2f LampAttributes::uv(int uv_layer) const
{
    if (uv_layer != active_uv_layer) {
        return V2f(0.0f);
    }
    switch (lamp_.kind) {
    case LampKind::Sun: return uv_of_sun();
    case LampKind::Area: return uv_of_area();
    case LampKind::Spot: return uv_of_spot();
    case LampKind::Point: break;
    }
    return uv_of_point();
}

V2f LampAttributes::parametric() const
{
    const V2f place = uv(active_uv_layer);
    return {place.y, 1.0f - place.x - place.y};
}

V2f LampAttributes::uv_of_point() const
{
    return uv_on_sphere(vector_to_object(facts_, smooth_normal()) * 0.5f + V3f(0.5f));
}

// The square around the cone, whatever its angle.
V2f LampAttributes::uv_of_spot() const
{
    const V3f beam = vector_to_object(facts_, -sight_.wi);
    const float edge = lamp_.one_minus_cos_half_angle;
    const float tangent = std::sqrt(edge * (2.0f - edge)) / (1.0f - edge);
    const float width = -2.0f * beam.z * tangent;
    return V2f(beam.x, beam.y) / width + V2f(0.5f);
}

V2f LampAttributes::uv_of_area() const
{
    const V3f from_center = to_place();
    // A mirrored lamp shows its picture mirrored.
    const M44f& m = facts_.world_from_object;
    const float side = lamp_.axis_y.dot({m[1][0], m[1][1], m[1][2]}) < 0.0f ? -1.0f : 1.0f;
    return {0.5f * from_center.dot(lamp_.axis_x) / lamp_.half_x + 0.5f,
            0.5f * from_center.dot(lamp_.axis_y) * side / lamp_.half_y + 0.5f};
}

// Equal areas of the disk for equal solid angles.
V2f LampAttributes::uv_of_sun() const
{
    if (lamp_.is_delta) {
        return V2f(0.5f);
    }
    // |wi - axis| is 2 sin(a / 2), a being the angle from the axis.
    const float diameter = 2.0f * std::sqrt(2.0f * lamp_.one_minus_cos_half_angle);
    const float from_axis = (sight_.wi - lamp_.axis_z).length() / diameter;
    const V3f beam = vector_to_object(facts_, sight_.wi);
    const float across = std::hypot(beam.x, beam.y);
    return across > 0.0f ? V2f(beam.x, beam.y) * (from_axis / across) + V2f(0.5f) : V2f(0.5f);
}

}  // namespace eye_render
