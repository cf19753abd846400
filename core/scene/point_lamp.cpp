// Point and spot lamps: without a radius, as a sphere, or as a disk turned to the lit point.

#include "base/warp.h"
#include "scene/lamp_shapes.h"
#include "shading/frame.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

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

}  // namespace

std::optional<LampSample> sample_point_lamp(const Lamp& lamp, const V3f& to_lamp, const V2f& u)
{
    if (lamp.is_delta) {
        return sample_delta(lamp, to_lamp);
    }
    return lamp.is_sphere ? sample_sphere(lamp, to_lamp, u) : sample_facing_disk(lamp, to_lamp, u);
}

std::optional<LampHit> hit_point_lamp(const Lamp& lamp, const V3f& to_lamp, const V3f& wi)
{
    return lamp.is_sphere ? hit_sphere(lamp, to_lamp, wi) : hit_facing_disk(lamp, to_lamp, wi);
}

}  // namespace eye_render
