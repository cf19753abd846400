#include "render/integrator.h"

#include "base/magnitude.h"
#include "render/aimed_light.h"
#include "render/multiple_importance.h"
#include "render/path_walk.h"
#include "render/shadow.h"
#include "render/subsurface.h"

namespace eye_render {

namespace {

// Of a path's random numbers, those of its walk: it has one at most, but straight passages.
constexpr std::uint64_t below_the_surface = max_straight_passages + 1;

class PathTracer : private PathWalk {
public:
    PathTracer(const Scene& scene,
               const IntegratorSettings& settings,
               SampleSequence& sequence,
               PassValues* values)
        : PathWalk(scene, settings, sequence, values), passes_(values, settings.surface_passes)
    {
    }

    PathRadiance trace(const Ray& camera_ray)
    {
        Ray ray = camera_ray;
        start(ray);
        for (;;) {
            auto hit = scene_.intersect(ray, path_);
            if (!hit) {
                media_.leave_meshes();
            }
            add_lamps(ray, hit ? hit->t : ray.t_max);
            if (media_.in_medium()) {
                const bool is_scattered = fly(ray, hit ? std::optional(hit->t) : std::nullopt);
                if (max_component(throughput_) <= 0.0f) {
                    break;
                }
                if (is_scattered) {
                    continue;
                }
            }
            if (hit && hit->material().is_boundary) {
                pass_through(ray, *hit);
                if (++boundaries_ > max_boundaries) {
                    break;
                }
                continue;
            }
            if (!hit) {
                add_background(ray);
                break;
            }
            path_.length = travelled_ + hit->t;
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
                ++path_.transparent_depth;
                pass_through(ray, *hit);
                continue;
            }
            add_direct_light(*hit, shaded.bsdf);

            const auto u = sequence_.next();
            auto sample = shaded.bsdf.sample(u[2], V2f(u[0], u[1]));
            if (sample && sample->subsurface != nullptr) {
                sample = come_out(*hit, shaded.bsdf, *sample);
            }
            if (!sample) {
                break;
            }
            throughput_ *= sample->weight;
            if (sample->is_straight) {
                ++path_.transparent_depth;
                pass_through(ray, *hit);
                continue;
            }
            if (path_.depth == 0 && light_.wants_shares()) {
                light_.scatter_first(scatter_shares(shaded.bsdf, *sample));
            }
            scatter(ray, *hit, *sample);
            if (!survives_roulette(u[3])) {
                break;
            }
        }
        return light_.seen();
    }

private:
    void be_caught(const Ray& camera_ray)
    {
        // Of the same random numbers, so that noise common to both paths leaves their ratio.
        SampleSequence alike = sequence_;
        PathTracer bare(scene_, settings_, alike, nullptr);
        bare.path_.sees_catchers_only = true;
        const Color3f behind = settings_.film_transparent
                                   ? Color3f(0.0f)
                                   : scene_.background(camera_ray.direction, path_);
        light_.be_caught(throughput_, throughput_ * bare.trace(camera_ray).radiance,
                         throughput_ * behind);
    }

    // Where light that entered below leaves the object: that is the hit from now on, with the
    // mixture that scatters it there.
    std::optional<BsdfSample> come_out(SurfaceHit& hit, Bsdf& bsdf, const BsdfSample& entry)
    {
        SampleSequence below = sequence_.branch(below_the_surface);
        const auto exit =
            sample_exit(scene_, hit, *entry.subsurface, throughput_ * entry.weight, below);
        if (!exit) {
            return std::nullopt;
        }
        hit = exit->hit;
        throughput_ = exit->throughput;
        bsdf = exit_bsdf(scene_, hit, path_);
        if (scene_.has_media()) {
            media_ = scene_.media_at(hit.origin_towards(hit.point.ng), hit.time);
        }
        add_direct_light(hit, bsdf);
        const auto u = sequence_.next();
        return bsdf.sample(u[2], V2f(u[0], u[1]));
    }

    void add_lamps(const Ray& ray, float t_end)
    {
        scene_.visit_lamps(
            last_->point, path_, ray.direction, travelled_, travelled_ + t_end,
            [this](const LampContribution& lamp) {
                if (!finds(lamp.links)) {
                    return;
                }
                const Color3f left = media_.in_medium()
                                         ? media_.mixture().transmittance(lamp.t - travelled_)
                                         : Color3f(1.0f);
                const float light_pdf =
                    last_->is_delta ? 0.0f : scene_.lamp_pdf(lamp, last_->point);
                light_.add(throughput_ * left * lamp.radiance * last_->weight_against(light_pdf),
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
        if (is_light(emission) && finds(hit.placement->links)) {
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
        // Where light passes through, lamps on both sides count.
        const V3f lit_side = bsdf.transmits() ? V3f(0.0f) : hit.point.ng;
        scene_.weigh_lights(hit.p_world, lit_side, last_.next_point());
        const auto light = aim_at_light(scene_, last_.next_point(), path_,
                                        hit.placement->light_class, sequence_.next());
        if (!light) {
            return;
        }
        BsdfValue scattered = bsdf.evaluate(light->wi);
        if (!light->visibility.to_all_scattering()) {
            scattered.value = light->visibility.seen_part(
                bsdf.parts(light->wi), light->wi.dot(hit.point.ng) < 0.0f, light->is_surface);
        }
        if (max_component(scattered.value) <= 0.0f) {
            return;
        }
        const float weight =
            light->is_met_by_rays ? power_heuristic(light->pdf, scattered.pdf) : 1.0f;
        const Color3f unblocked = unshadowed(scene_, hit, *light, path_, passages_left(), media_);
        if (path_.depth == 0 && light->lamp_probability > 0.0f && light_.wants_shadow()) {
            const Color3f covered = throughput_ * (Color3f(1.0f) - bsdf.straight());
            light_.add_shadow(covered * unblocked /
                              (light->lamp_probability * static_cast<float>(scene_.lamp_count())));
        }
        const Color3f contribution =
            throughput_ * scattered.value * light->radiance * (weight / light->pdf) * unblocked;
        light_.add_lit(contribution, light->origin, path_.depth + 1, bsdf, light->wi);
    }

    SurfacePasses passes_;
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
