#include "render/path_walk.h"

#include "render/medium_flight.h"

#include <limits>

namespace eye_render {

bool PathWalk::fly(Ray& ray, std::optional<float> t_surface)
{
    const float t_end = t_surface.value_or(std::numeric_limits<float>::infinity());
    const ParticipatingMedium& medium = media_.mixture();
    const MediumSegment segment{.origin = ray.origin + ray.direction * ray.t_min,
                                .direction = ray.direction,
                                .length = t_end - ray.t_min,
                                .time = ray.time,
                                .media = media_};
    media_.visit_emission([&](const Color3f& emission, const Placement* placement) {
        const int group =
            placement != nullptr ? placement->light_group : scene_.world_origin().group;
        light_.add(throughput_ * medium.emitted(emission, segment.length), {.group = group},
                   path_.depth);
    });
    if (!medium.is_scattering() ||
        had_last_bounce(path_, settings_.max_bounces, settings_.limits)) {
        throughput_ *= medium.transmittance(segment.length);
        return false;
    }
    const ScatteredLight lit = sample_scattered_light(
        scene_, segment, throughput_, path_, passages_left(), last_.next_point(), sequence_);
    light_.add_lit_in_medium(lit.light, lit.origin, path_.depth + 1);
    const MediumFlight flight = sample_flight(segment, throughput_, sequence_);
    throughput_ *= flight.weight;
    if (!flight.collision) {
        return false;
    }
    const auto& [p_world, direction, pdf] = *flight.collision;
    if (path_.depth == 0) {
        light_.scatter_first(shares_of_medium);
    }
    note_medium_scattering(path_, pdf);
    light_class_ = light_class_of_media;
    shows_film_ = false;
    length_ += (p_world - ray.origin).length();
    scene_.weigh_lights(p_world, V3f(0.0f), last_.next_point());
    last_.move_on(p_world, pdf, false);
    travelled_ = 0.0f;
    ray = {.origin = p_world, .direction = direction, .time = ray.time};
    if (!survives_roulette(sequence_.next()[0])) {
        throughput_ = Color3f(0.0f);
    }
    return true;
}

void PathWalk::scatter(Ray& ray, const SurfaceHit& hit, const BsdfSample& sample)
{
    note_scattering(path_, sample, settings_.limits);
    light_class_ = hit.placement->light_class;
    shows_film_ = shows_film_ && sample.is_transmitted &&
                  sample.alpha_squared <= settings_.clear_alpha_squared;
    if (sample.is_transmitted) {
        media_.cross(hit);
    }
    length_ += hit.t;
    last_.move_on(hit.p_world, sample.pdf, sample.is_delta);
    travelled_ = 0.0f;
    ray = hit.ray_towards(sample.wi);
}

bool PathWalk::survives_roulette(float u)
{
    const float probability = roulette_survival(path_.depth, throughput_);
    if (!(u < probability)) {
        return false;
    }
    throughput_ /= probability;
    return true;
}

}  // namespace eye_render
