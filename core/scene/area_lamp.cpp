// Area lamps: rectangles and disks that shine from one side, and their honeycomb grid.

#include "base/warp.h"
#include "scene/lamp_shapes.h"
#include "scene/spherical_rectangle.h"

#include <cmath>

namespace eye_render {

namespace {

// Below this solid angle (sr) a rectangle is sampled by area: the sum of angles that gives the
// solid angle is only good to 1e-6 in float, and cos/t^2 hardly varies over so small a target.
constexpr float smallest_spherical_rectangle = 5e-3f;

// Share of the light that the grid of an area lamp lets through: slats hide what a tilted view
// sees between them in proportion to the tangent of the tilt.
float grid_falloff(const Lamp& lamp, float cosine)
{
    if (lamp.cot_half_spread == 0.0f) {
        return 1.0f;
    }
    const float tangent = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine)) / cosine;
    return std::max(0.0f, 1.0f - tangent * lamp.cot_half_spread);
}

// The solid angle that the rectangle is sampled by, or nothing where it is sampled by area.
std::optional<SphericalRectangle> spherical_rectangle(const Lamp& lamp, const V3f& to_lamp)
{
    if (lamp.shape != LampShape::Rectangle) {
        return std::nullopt;
    }
    // No rectangle subtends more than its area over the squared distance to its nearest point,
    // which is no nearer than its centre less half a diagonal; this spares most far lamps the
    // inverse cosines.
    const float nearest =
        to_lamp.length() - std::sqrt(lamp.half_x * lamp.half_x + lamp.half_y * lamp.half_y);
    if (nearest > 0.0f &&
        area_lamp_area(lamp) < smallest_spherical_rectangle * nearest * nearest) {
        return std::nullopt;
    }
    const V3f corner = to_lamp - lamp.axis_x * lamp.half_x - lamp.axis_y * lamp.half_y;
    const SphericalRectangle rectangle(corner, lamp.axis_x, lamp.axis_y, 2.0f * lamp.half_x,
                                       2.0f * lamp.half_y);
    return rectangle.solid_angle() > smallest_spherical_rectangle ? std::optional(rectangle)
                                                                  : std::nullopt;
}

// Per unit solid angle, of a point of the lamp at distance t: one over the solid angle, or
// t^2 / (cos * area).
float area_pdf(const Lamp& lamp,
               const std::optional<SphericalRectangle>& rectangle,
               float t,
               float cosine)
{
    return rectangle ? 1.0f / rectangle->solid_angle() : t * t / (cosine * area_lamp_area(lamp));
}

}  // namespace

std::optional<LampSample> sample_area_lamp(const Lamp& lamp, const V3f& to_lamp, const V2f& u)
{
    // In front means against axis_z; on the plane itself nothing is seen of the lamp.
    if (to_lamp.dot(lamp.axis_z) <= 0.0f) {
        return std::nullopt;
    }
    const std::optional<SphericalRectangle> rectangle = spherical_rectangle(lamp, to_lamp);
    V3f to_point;
    if (rectangle) {
        to_point = rectangle->sample(u);
    } else {
        const V2f p =
            lamp.shape == LampShape::Disk ? sample_uniform_disk(u) : u * 2.0f - V2f(1.0f);
        to_point = to_lamp + lamp.axis_x * (p.x * lamp.half_x) + lamp.axis_y * (p.y * lamp.half_y);
    }
    const float t = to_point.length();
    const V3f wi = to_point / t;
    const float cosine = wi.dot(lamp.axis_z);
    if (!(cosine > 0.0f)) {
        return std::nullopt;
    }
    return LampSample{.wi = wi,
                      .distance = t,
                      .radiance = lamp.emission * grid_falloff(lamp, cosine),
                      .pdf = area_pdf(lamp, rectangle, t, cosine)};
}

std::optional<LampHit> hit_area_lamp(const Lamp& lamp, const V3f& to_lamp, const V3f& wi)
{
    const float cosine = wi.dot(lamp.axis_z);
    const float height = to_lamp.dot(lamp.axis_z);
    if (cosine <= 0.0f || height <= 0.0f) {
        return std::nullopt;
    }
    const float t = height / cosine;
    const V3f from_center = wi * t - to_lamp;
    const float x = from_center.dot(lamp.axis_x) / lamp.half_x;
    const float y = from_center.dot(lamp.axis_y) / lamp.half_y;
    const bool inside = lamp.shape == LampShape::Disk ? x * x + y * y <= 1.0f
                                                      : std::abs(x) <= 1.0f && std::abs(y) <= 1.0f;
    if (!inside) {
        return std::nullopt;
    }
    return LampHit{t, lamp.emission * grid_falloff(lamp, cosine),
                   area_pdf(lamp, spherical_rectangle(lamp, to_lamp), t, cosine)};
}

}  // namespace eye_render
