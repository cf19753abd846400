// Light sampling in a scene: one light of any kind for a point.

#include "scene/light_path.h"
#include "scene/scene.h"

#include <limits>

namespace eye_render {

std::optional<IncomingLight> Scene::sample_light(const LitPoint& point,
                                                 double u_light,
                                                 const V2f& u) const
{
    const auto choice = light_sampler_.choose(point, u_light);
    if (!choice) {
        return std::nullopt;
    }
    auto light = sample_chosen(*choice, point, u);
    if (!light || !(light->pdf > 0.0f)) {
        return std::nullopt;
    }
    light->pdf *= choice->probability;
    return light;
}

std::optional<IncomingLight> Scene::sample_chosen(const LightChoice& choice,
                                                  const LitPoint& point,
                                                  const V2f& u) const
{
    if (choice.kind == LightKind::Triangle) {
        return sample_emitter(choice.index, point, u);
    }
    if (choice.kind == LightKind::Environment) {
        const EnvironmentSample sample = environment_.sample(u);
        return IncomingLight{.wi = sample.wi,
                             .distance = std::numeric_limits<float>::infinity(),
                             .radiance = sample.radiance,
                             .pdf = sample.pdf,
                             .visibility = data_.world_visibility,
                             .origin = world_origin()};
    }
    Room<MovedLamp> moved;
    const Lamp& lamp = lamp_at(choice.index, point.time, moved);
    const auto sample = sample_lamp(lamp, point.p_world, u);
    if (!sample) {
        return std::nullopt;
    }
    const LampSight sight{
        .p_lit_world = point.p_world, .wi = sample->wi, .distance = sample->distance};
    const LampData& data = data_.lamps[choice.index];
    return IncomingLight{
        .wi = sample->wi,
        .distance = sample->distance * (1.0f - shadow_margin),
        .radiance = sample->radiance * lamp_factor(choice.index, moved, sight, light_path),
        .pdf = sample->pdf,
        .is_met_by_rays = !lamp.is_delta && lamp.casts_shadow && data.links.blocker_set == 0,
        .casts_shadow = lamp.casts_shadow,
        .visibility = lamp.visibility,
        .links = data.links,
        .origin = {.group = data.light_group},
        .lamp_probability = choice.probability};
}

std::optional<V3f> Scene::light_center(const LitPoint& point, double u_light) const
{
    const auto choice = light_sampler_.choose(point, u_light);
    if (!choice || choice->kind == LightKind::Environment) {
        return std::nullopt;
    }
    if (choice->kind == LightKind::Triangle) {
        const auto [p0, p1, p2] = corners_world(emitters_[choice->index], point.time);
        return (p0 + p1 + p2) / 3.0f;
    }
    Room<MovedLamp> moved;
    const Lamp& lamp = lamp_at(choice->index, point.time, moved);
    return lamp.kind == LampKind::Sun ? std::nullopt : std::optional(lamp.position);
}

float Scene::environment_pdf(const V3f& wi, const LitPoint& point) const
{
    return environment_.pdf(wi) * light_sampler_.probability(LightKind::Environment, 0, point);
}

}  // namespace eye_render
