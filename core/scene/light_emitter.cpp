#include "scene/light_emitter.h"

#include "scene/environment.h"

#include <cmath>
#include <numbers>

namespace eye_render {

LightEmitter emitter_of(const Lamp& lamp, std::uint32_t index)
{
    LightEmitter e{.kind = LightKind::Lamp,
                   .index = index,
                   .center_world = lamp.position,
                   .radius = lamp.radius,
                   .intensity = lamp_peak_intensity(lamp)};
    switch (lamp.kind) {
    case LampKind::Point: break;
    case LampKind::Sun:
        e.is_distant = true;
        e.axis = -lamp.axis_z;
        e.cos_edge = 1.0f - lamp.one_minus_cos_half_angle;
        break;
    case LampKind::Spot:
        // The cone through the edge of a lamp with a radius starts behind its centre; that and a
        // cone stretched to an ellipse have no bound here.
        if (lamp.radius == 0.0f && lamp.spot_scale_x == lamp.spot_scale_y) {
            const float cosine = 1.0f - lamp.one_minus_cos_half_angle;
            const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
            e.axis = -lamp.axis_z;
            e.cos_edge = cosine / std::hypot(cosine, sine / lamp.spot_scale_x);
        }
        break;
    case LampKind::Area:
        e.radius = std::hypot(lamp.half_x, lamp.half_y);
        e.is_lambertian = true;
        e.axis = -lamp.axis_z;
        e.cos_edge = lamp.cot_half_spread / std::hypot(1.0f, lamp.cot_half_spread);
        break;
    }
    if (lamp.moves) {
        e.radius = lamp.reach;
        e.axis = V3f(0.0f);
        e.is_lambertian = false;
    }
    return e;
}

LightEmitter emitter_of(const EmissiveTriangle& t, std::uint32_t index)
{
    Imath::Box3f box(t.p0_world);
    box.extendBy(t.p1_world);
    box.extendBy(t.p2_world);
    box.extendBy(t.reach);
    return {.kind = LightKind::Triangle,
            .index = index,
            .center_world = box.center(),
            .radius = 0.5f * box.size().length(),
            .intensity = triangle_area(t.p0_world, t.p1_world, t.p2_world) * t.radiance};
}

LightEmitter emitter_of(const Environment& environment)
{
    constexpr float pi_f = std::numbers::pi_v<float>;
    return {.kind = LightKind::Environment,
            .intensity = pi_f * environment.mean_luminance(),
            .is_distant = true};
}

}  // namespace eye_render
