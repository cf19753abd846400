#include "render/medium_light.h"

#include "base/magnitude.h"
#include "render/aimed_light.h"
#include "render/free_flight.h"
#include "render/multiple_importance.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

struct Place {
    float distance = 0.0f;
    float pdf = 0.0f;
};

// Where on the segment light shall be scattered: half of the places go by how much light flies
// on from there, half by how near a lamp is.
[[nodiscard]] Place sample_place(const Scene& scene,
                                 const MediumSegment& segment,
                                 const Color3f& importance,
                                 LitPoint& point,
                                 SampleSequence& sequence)
{
    const ParticipatingMedium& medium = segment.media.mixture();
    const FreeFlight flight(medium.extinction, importance, segment.length);
    const auto u = sequence.next();
    const auto v = sequence.next();
    // The lamp must not hang on the place, so it is chosen for one that is no sample.
    const float typical = std::min(0.5f * segment.length, 1.0f / max_component(medium.extinction));
    scene.weigh_lights(segment.origin + segment.direction * typical, V3f(0.0f), point);
    const auto lamp = scene.light_center(point, light_choice(u[0], u[1]));
    if (!lamp) {
        const float distance = flight.sample_within(v[0], v[1]);
        return {distance, flight.pdf_within(distance)};
    }
    const EquiangularDistance near_lamp(segment.origin, segment.direction, segment.length, *lamp);
    const float distance = u[2] < 0.5f ? flight.sample_within(v[0], v[1]) : near_lamp.sample(v[1]);
    return {distance, 0.5f * (flight.pdf_within(distance) + near_lamp.pdf(distance))};
}

}  // namespace

ScatteredLight sample_scattered_light(const Scene& scene,
                                      const MediumSegment& segment,
                                      const Color3f& throughput,
                                      const PathState& path,
                                      int most_passages,
                                      LitPoint& point,
                                      SampleSequence& sequence)
{
    const ParticipatingMedium& medium = segment.media.mixture();
    const Color3f importance = throughput * medium.scattering();
    if (!(max_component(importance) > 0.0f) || !(segment.length > 0.0f)) {
        return {};
    }
    const Place place = sample_place(scene, segment, importance, point, sequence);
    if (!(place.pdf > 0.0f) || !std::isfinite(place.distance)) {
        return {};
    }
    const V3f p_world = segment.origin + segment.direction * place.distance;
    scene.weigh_lights(p_world, V3f(0.0f), point);
    const auto light = aim_at_light(scene, point, path, light_class_of_media, sequence.next());
    if (!light || !light->visibility.to_volume_scatter) {
        return {};
    }
    const float turned = one_minus_cosine(segment.direction, light->wi);
    const float weight =
        light->is_met_by_rays ? power_heuristic(light->pdf, medium.pdf(turned)) : 1.0f;
    Color3f scattered = throughput * medium.transmittance(place.distance) *
                        medium.scattered(turned) * light->radiance *
                        (weight / (light->pdf * place.pdf));
    if (light->casts_shadow && is_light(scattered)) {
        MediumStack media = segment.media;
        scattered *= scene.transmittance({.origin = p_world,
                                          .direction = light->wi,
                                          .t_max = light->distance,
                                          .time = segment.time},
                                         path, most_passages, &media, light->links.blocker_set);
    }
    return {scattered, light->origin};
}

}  // namespace eye_render
