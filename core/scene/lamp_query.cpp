// What a point sees of a lamp: the sampled direction, and the lamp that a ray meets.

#include "base/magnitude.h"
#include "base/warp.h"
#include "scene/lamp_shapes.h"
#include "shading/frame.h"

#include <limits>

namespace eye_render {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

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

std::optional<LampHit> hit_sun(const Lamp& lamp, const V3f& wi)
{
    // |wi - axis|^2 = 2 (1 - cos), exact to the float even for the real sun's 1e-5.
    if ((wi - lamp.axis_z).length2() > 2.0f * lamp.one_minus_cos_half_angle) {
        return std::nullopt;
    }
    return LampHit{infinity, lamp.emission, uniform_cone_pdf(lamp.one_minus_cos_half_angle)};
}

}  // namespace

std::optional<LampSample> sample_lamp(const Lamp& lamp, const V3f& p_world, const V2f& u)
{
    if (lamp.kind == LampKind::Sun) {
        return sample_sun(lamp, u);
    }
    const V3f to_lamp = lamp.position - p_world;
    const std::optional<LampSample> sample = lamp.kind == LampKind::Area
                                                 ? sample_area_lamp(lamp, to_lamp, u)
                                                 : sample_point_lamp(lamp, to_lamp, u);
    return sample && is_light(sample->radiance) ? sample : std::nullopt;
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
    switch (lamp.kind) {
    case LampKind::Sun: hit = hit_sun(lamp, direction); break;
    case LampKind::Area: hit = hit_area_lamp(lamp, to_lamp, direction); break;
    case LampKind::Point:
    case LampKind::Spot: hit = hit_point_lamp(lamp, to_lamp, direction); break;
    }
    const bool lights = hit && hit->t <= t_max && is_light(hit->radiance);
    return lights ? hit : std::nullopt;
}

}  // namespace eye_render
