// What a point sees of a lamp: the sampled direction, and the lamp that a ray meets. Each shape
// has one function of either kind, and one density that both share.

#include "scene/lamp.h"

#include "base/warp.h"
#include "scene/spherical_rectangle.h"
#include "shading/frame.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace eye_render {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float pi_f = std::numbers::pi_v<float>;

// Below this solid angle (sr) a rectangle is sampled by area: the sum of angles that gives the
// solid angle is only good to 1e-6 in float, and cos/t^2 hardly varies over so small a target.
constexpr float smallest_spherical_rectangle = 5e-3f;

float smoothstep(float t)
{
    const float x = std::clamp(t, 0.0f, 1.0f);
    return x * x * (3.0f - 2.0f * x);
}

// Share of a spot's light in direction `wi` (from the lit point to the lamp), 0 to 1.
float spot_falloff(const Lamp& lamp, const V3f& wi)
{
    const float cosine = wi.dot(lamp.axis_z);
    if (cosine <= 0.0f) {
        return 0.0f;
    }
    const float x = wi.dot(lamp.axis_x) * lamp.spot_scale_x;
    const float y = wi.dot(lamp.axis_y) * lamp.spot_scale_y;
    const float cone_cosine = cosine / std::sqrt(x * x + y * y + cosine * cosine);
    const float above_edge = cone_cosine - (1.0f - lamp.one_minus_cos_half_angle);
    if (above_edge <= 0.0f) {
        return 0.0f;
    }
    const float soft =
        above_edge < lamp.spot_smooth ? smoothstep(above_edge / lamp.spot_smooth) : 1.0f;
    return lamp.spot_cosine_falloff ? soft * cosine : soft;
}

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

Color3f radiance_towards(const Lamp& lamp, const V3f& wi)
{
    return lamp.kind == LampKind::Spot ? lamp.emission * spot_falloff(lamp, wi) : lamp.emission;
}

// 1 - cos of the half angle that a sphere subtends, from the squared sine; without cancellation.
float one_minus_cos_from_sin2(float sin2) { return sin2 / (1.0f + std::sqrt(1.0f - sin2)); }

std::optional<LampSample> sample_delta(const Lamp& lamp, const V3f& to_lamp)
{
    const float distance2 = to_lamp.length2();
    if (distance2 == 0.0f) {
        return std::nullopt;
    }
    const float distance = std::sqrt(distance2);
    const V3f wi = to_lamp / distance;
    return LampSample{.wi = wi,
                      .distance = distance,
                      .radiance = radiance_towards(lamp, wi) / distance2,
                      .pdf = 1.0f,
                      .is_delta = true};
}

std::optional<LampSample> sample_sphere(const Lamp& lamp, const V3f& to_lamp, const V2f& u)
{
    const float radius2 = lamp.radius * lamp.radius;
    const float distance2 = to_lamp.length2();
    if (distance2 <= radius2) {
        // Inside: every direction meets the sphere once.
        const V3f wi = sample_uniform_sphere(u);
        const float along = to_lamp.dot(wi);
        const float t = along + std::sqrt(std::max(0.0f, radius2 - distance2 + along * along));
        return LampSample{
            .wi = wi, .distance = t, .radiance = lamp.emission, .pdf = uniform_sphere_pdf()};
    }
    const float distance = std::sqrt(distance2);
    const float one_minus_cos = one_minus_cos_from_sin2(radius2 / distance2);
    const V3f local = sample_uniform_cone(u, one_minus_cos);
    const V3f wi = Frame(to_lamp / distance).world_from_local(local);
    // The near crossing of the ray, by Pythagoras over its closest approach to the centre.
    const float approach2 = distance2 * (local.x * local.x + local.y * local.y);
    const float t = distance * local.z - std::sqrt(std::max(0.0f, radius2 - approach2));
    return LampSample{.wi = wi,
                      .distance = t,
                      .radiance = radiance_towards(lamp, wi),
                      .pdf = uniform_cone_pdf(one_minus_cos)};
}

// Density of the disk's points per unit solid angle: t^2 / (cos * area).
float facing_disk_pdf(const Lamp& lamp, float t, float cosine)
{
    return t * t / (cosine * pi_f * lamp.radius * lamp.radius);
}

std::optional<LampSample> sample_facing_disk(const Lamp& lamp, const V3f& to_lamp, const V2f& u)
{
    const float distance = to_lamp.length();
    if (distance == 0.0f) {
        return std::nullopt;
    }
    const Frame frame(to_lamp / distance);
    const V2f p = sample_uniform_disk(u) * lamp.radius;
    const V3f to_point = frame.world_from_local(V3f(p.x, p.y, distance));
    const float t = to_point.length();
    const V3f wi = to_point / t;
    return LampSample{.wi = wi,
                      .distance = t,
                      .radiance = radiance_towards(lamp, wi),
                      .pdf = facing_disk_pdf(lamp, t, distance / t)};
}

LampSample sample_sun(const Lamp& lamp, const V2f& u)
{
    if (lamp.is_delta) {
        return {.wi = lamp.axis_z,
                .distance = infinity,
                .radiance = lamp.emission,
                .pdf = 1.0f,
                .is_delta = true};
    }
    const V3f local = sample_uniform_cone(u, lamp.one_minus_cos_half_angle);
    return {.wi = Frame(lamp.axis_z).world_from_local(local),
            .distance = infinity,
            .radiance = lamp.emission,
            .pdf = uniform_cone_pdf(lamp.one_minus_cos_half_angle)};
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

std::optional<LampSample> sample_area(const Lamp& lamp, const V3f& to_lamp, const V2f& u)
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
    const float pdf =
        rectangle ? 1.0f / rectangle->solid_angle() : t * t / (cosine * area_lamp_area(lamp));
    return LampSample{.wi = wi,
                      .distance = t,
                      .radiance = lamp.emission * grid_falloff(lamp, cosine),
                      .pdf = pdf};
}

std::optional<LampHit> hit_sphere(const Lamp& lamp, const V3f& to_lamp, const V3f& wi)
{
    const float radius2 = lamp.radius * lamp.radius;
    const float distance2 = to_lamp.length2();
    const float along = to_lamp.dot(wi);
    const float half_chord2 = radius2 - (to_lamp - wi * along).length2();
    if (distance2 <= radius2) {
        return LampHit{along + std::sqrt(std::max(0.0f, half_chord2)), lamp.emission,
                       uniform_sphere_pdf()};
    }
    if (along <= 0.0f || half_chord2 <= 0.0f) {
        return std::nullopt;
    }
    return LampHit{along - std::sqrt(half_chord2), radiance_towards(lamp, wi),
                   uniform_cone_pdf(one_minus_cos_from_sin2(radius2 / distance2))};
}

std::optional<LampHit> hit_facing_disk(const Lamp& lamp, const V3f& to_lamp, const V3f& wi)
{
    const float distance = to_lamp.length();
    const float along = to_lamp.dot(wi);
    if (along <= 0.0f) {
        return std::nullopt;
    }
    const float cosine = along / distance;
    const float t = distance / cosine;
    if ((wi * t - to_lamp).length2() >= lamp.radius * lamp.radius) {
        return std::nullopt;
    }
    return LampHit{t, radiance_towards(lamp, wi), facing_disk_pdf(lamp, t, cosine)};
}

std::optional<LampHit> hit_sun(const Lamp& lamp, const V3f& wi)
{
    // |wi - axis|^2 = 2 (1 - cos), exact to the float even for the real sun's 1e-5.
    if ((wi - lamp.axis_z).length2() > 2.0f * lamp.one_minus_cos_half_angle) {
        return std::nullopt;
    }
    return LampHit{infinity, lamp.emission, uniform_cone_pdf(lamp.one_minus_cos_half_angle)};
}

std::optional<LampHit> hit_area(const Lamp& lamp, const V3f& to_lamp, const V3f& wi)
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
    const std::optional<SphericalRectangle> rectangle = spherical_rectangle(lamp, to_lamp);
    const float pdf =
        rectangle ? 1.0f / rectangle->solid_angle() : t * t / (cosine * area_lamp_area(lamp));
    return LampHit{t, lamp.emission * grid_falloff(lamp, cosine), pdf};
}

}  // namespace

std::optional<LampSample> sample_lamp(const Lamp& lamp, const V3f& p_world, const V2f& u)
{
    const V3f to_lamp = lamp.position - p_world;
    std::optional<LampSample> sample;
    if (lamp.kind == LampKind::Sun) {
        return sample_sun(lamp, u);
    }
    if (lamp.kind == LampKind::Area) {
        sample = sample_area(lamp, to_lamp, u);
    } else if (lamp.is_delta) {
        sample = sample_delta(lamp, to_lamp);
    } else {
        sample = lamp.is_sphere ? sample_sphere(lamp, to_lamp, u)
                                : sample_facing_disk(lamp, to_lamp, u);
    }
    return sample && max_component(sample->radiance) > 0.0f ? sample : std::nullopt;
}

std::optional<LampHit> lamp_hit(const Lamp& lamp,
                                const V3f& origin_world,
                                const V3f& direction,
                                float t_max)
{
    if (lamp.is_delta) {
        return std::nullopt;
    }
    const V3f to_lamp = lamp.position - origin_world;
    std::optional<LampHit> hit;
    if (lamp.kind == LampKind::Sun) {
        hit = hit_sun(lamp, direction);
    } else if (lamp.kind == LampKind::Area) {
        hit = hit_area(lamp, to_lamp, direction);
    } else {
        hit = lamp.is_sphere ? hit_sphere(lamp, to_lamp, direction)
                             : hit_facing_disk(lamp, to_lamp, direction);
    }
    const bool lights = hit && hit->t <= t_max && max_component(hit->radiance) > 0.0f;
    return lights ? hit : std::nullopt;
}

}  // namespace eye_render
