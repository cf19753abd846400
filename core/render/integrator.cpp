#include "render/integrator.h"

#include "render/multiple_importance.h"
#include "render/path_state.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace eye_render {

namespace {

class PathTracer {
public:
    PathTracer(const Scene& scene,
               const IntegratorSettings& settings,
               SampleSequence& sequence,
               PassValues* values)
        : scene_(scene), settings_(settings), sequence_(sequence), light_(values, settings.limits),
          passes_(values, settings.surface_passes)
    {
    }

    PathTracer(const PathTracer&) = delete;
    PathTracer& operator=(const PathTracer&) = delete;

    PathRadiance trace(const Ray& camera_ray)
    {
        last_->point.p_world = camera_ray.origin;
        Ray ray = camera_ray;
        for (;;) {
            auto hit = scene_.intersect(ray, path_);
            add_lamps(ray, hit ? hit->t : ray.t_max);
            if (!hit) {
                add_background(ray);
                break;
            }
            path_.length = hit->t;
            hit->point.footprint = settings_.pixel_slope * (length_ + hit->t);
            ShadedPoint shaded = scene_.shade(*hit, path_);
            if (shows_film_ && cut_out(*hit, shaded)) {
                break;
            }
            if (hit->placement->is_shadow_catcher && path_.depth == 0 && light_.may_be_caught()) {
                be_caught(camera_ray);
            }
            passes_.note({.scene = scene_,
                          .hit = *hit,
                          .shaded = shaded,
                          .path = path_,
                          .throughput = throughput_},
                         sequence_.branch(static_cast<std::uint64_t>(path_.transparent_depth)));
            add_emission(*hit, shaded.emission);
            if (path_.transparent_depth > settings_.limits.transparent_bounces) {
                break;
            }
            blur_after(path_, settings_.limits, shaded.bsdf);
            if (had_last_bounce(path_, settings_.max_bounces, settings_.limits)) {
                // The ray after the last bounce only collects what shines by itself, through
                // whatever lets it pass: light sampling sees through the same surfaces.
                throughput_ *= scene_.straight_transmittance(*hit, path_);
                if (max_component(throughput_) <= 0.0f) {
                    break;
                }
                pass_through(ray, *hit);
                continue;
            }
            add_direct_light(*hit, shaded.bsdf);

            const auto u = sequence_.next();
            const auto sample = shaded.bsdf.sample(u[2], V2f(u[0], u[1]));
            if (!sample) {
                break;
            }
            throughput_ *= sample->weight;
            if (sample->is_straight) {
                pass_through(ray, *hit);
                continue;
            }
            length_ += hit->t;
            if (path_.depth == 0 && light_.wants_shares()) {
                light_.scatter_first(scatter_shares(shaded.bsdf, *sample));
            }
            scatter(*sample);
            std::swap(last_, here_);
            last_->point.p_world = hit->p_world;
            last_->pdf = sample->pdf;
            last_->is_delta = sample->is_delta;
            travelled_ = 0.0f;
            ray = {.origin = hit->origin_towards(sample->wi),
                   .direction = sample->wi,
                   .time = ray.time};
            if (!survives_roulette(u[3])) {
                break;
            }
        }
        return light_.seen();
    }

private:
    void be_caught(const Ray& camera_ray)
    {
        SampleSequence alike = sequence_;  // so that noise is, too
        PathTracer bare(scene_, settings_, alike, nullptr);
        bare.path_.sees_catchers_only = true;
        const Color3f behind = settings_.film_transparent
                                   ? Color3f(0.0f)
                                   : scene_.background(camera_ray.direction, path_);
        light_.be_caught(throughput_, throughput_ * bare.trace(camera_ray).radiance,
                         throughput_ * behind);
    }

    void pass_through(Ray& ray, const SurfaceHit& hit)
    {
        travelled_ += hit.t;
        length_ += hit.t;
        ++path_.transparent_depth;
        ray = passed_through(ray, hit);
    }

    void scatter(const BsdfSample& sample)
    {
        note_scattering(path_, sample, settings_.limits);
        shows_film_ = shows_film_ && sample.is_transmitted &&
                      sample.alpha_squared <= settings_.clear_alpha_squared;
    }

    void add_lamps(const Ray& ray, float t_end)
    {
        scene_.visit_lamps(last_->point, path_, ray.direction, travelled_, travelled_ + t_end,
                           [this](const LampContribution& lamp) {
                               light_.add(throughput_ * lamp.radiance *
                                              last_->weight_against(lamp.pdf),
                                          lamp.origin, path_.depth);
                           });
    }

    // True where a holdout leaves nothing to be seen.
    bool cut_out(const SurfaceHit& hit, const ShadedPoint& shaded)
    {
        const float share = hit.placement->is_holdout ? 1.0f : std::min(shaded.holdout, 1.0f);
        if (share > 0.0f) {
            light_.uncover(throughput_ * share);
        }
        return share == 1.0f;
    }

    void add_background(const Ray& ray)
    {
        if (shows_film_ && settings_.film_transparent) {
            // What the surfaces before it took away stays in the picture as coverage.
            light_.uncover(throughput_);
            if (light_.wants_world_behind_film()) {
                light_.add_behind_film(throughput_ * scene_.background(ray.direction, path_));
            }
            return;
        }
        passes_.note_world(scene_, ray.direction, path_, throughput_);
        const float light_pdf =
            last_->is_delta ? 0.0f : scene_.environment_pdf(ray.direction, last_->point);
        light_.add(throughput_ * scene_.background(ray.direction, path_) *
                       last_->weight_against(light_pdf),
                   scene_.world_origin(), path_.depth);
    }

    void add_emission(const SurfaceHit& hit, const Color3f& emission)
    {
        if (max_component(emission) > 0.0f) {
            const float light_pdf = last_->is_delta ? 0.0f : scene_.emitter_pdf(hit, last_->point);
            light_.add(throughput_ * emission * last_->weight_against(light_pdf),
                       {.group = hit.placement->light_group}, path_.depth);
        }
    }

    void add_direct_light(const SurfaceHit& hit, const Bsdf& bsdf)
    {
        if (bsdf.is_delta_only()) {
            return;
        }
        const auto u = sequence_.next();
        // Where light passes through, lamps on both sides count.
        const V3f lit_side = bsdf.transmits() ? V3f(0.0f) : hit.point.ng;
        scene_.weigh_lights(hit.p_world, lit_side, here_->point);
        // A float's 24 bits are too few to choose among many lights.
        const double choice = u[2] + 0x1p-24 * static_cast<double>(u[3]);
        const auto light = scene_.sample_light(here_->point, choice, V2f(u[0], u[1]));
        if (!light || (path_.sees_catchers_only && !light->is_of_catcher)) {
            return;
        }
        BsdfValue scattered = bsdf.evaluate(light->wi);
        if (!light->visibility.to_all_scattering()) {
            scattered.value = light->visibility.seen_part(bsdf.parts(light->wi));
        }
        if (max_component(scattered.value) <= 0.0f) {
            return;
        }
        const float weight =
            light->is_met_by_rays ? power_heuristic(light->pdf, scattered.pdf) : 1.0f;
        Color3f contribution =
            throughput_ * scattered.value * light->radiance * (weight / light->pdf);
        if (light->casts_shadow) {
            contribution *= scene_.transmittance(shadow_ray(hit, *light), path_,
                                                 settings_.limits.transparent_bounces -
                                                     path_.transparent_depth);
        }
        light_.add_lit(contribution, light->origin, path_.depth + 1, bsdf, light->wi);
    }

    bool survives_roulette(float u)
    {
        const float probability = roulette_survival(path_.depth, throughput_);
        if (!(u < probability)) {
            return false;
        }
        throughput_ /= probability;
        return true;
    }

    const Scene& scene_;
    const IntegratorSettings& settings_;
    SampleSequence& sequence_;
    PathLight light_;
    SurfacePasses passes_;
    Color3f throughput_{1.0f};
    std::array<Scattering, 2> scatterings_;
    Scattering* last_ = scatterings_.data();
    Scattering* here_ =
        scatterings_.data() + 1;  // becomes the last one when the path is scattered here
    float travelled_ = 0.0f;      // from the last scattering, through straight passages
    float length_ = 0.0f;         // of all of the path
    PathState path_;
    bool shows_film_ = true;  // nothing has come between it and the eye but what is clear
};

}  // namespace

PathRadiance trace_path(const Scene& scene,
                        const IntegratorSettings& settings,
                        const Ray& camera_ray,
                        SampleSequence& sequence,
                        PassValues* values)
{
    return PathTracer(scene, settings, sequence, values).trace(camera_ray);
}

}  // namespace eye_render
