// How a path goes through a scene: past surfaces that let it, through media, from where it was
// scattered, and until roulette ends it. What light it finds on its way is the integrator's.

#pragma once

#include "render/integrator.h"
#include "render/multiple_importance.h"
#include "render/path_state.h"

#include <cmath>

namespace eye_render {

class PathWalk {
public:
    PathWalk(const PathWalk&) = delete;
    PathWalk& operator=(const PathWalk&) = delete;

protected:
    PathWalk(const Scene& scene,
             const IntegratorSettings& settings,
             SampleSequence& sequence,
             PassValues* values)
        : scene_(scene), settings_(settings), sequence_(sequence), light_(values, settings.limits),
          media_(nullptr)
    {
    }
    ~PathWalk() = default;

    void start(const Ray& ray)
    {
        last_.start(ray.origin, ray.time);
        if (scene_.has_media()) {
            media_ = scene_.media_at(ray.origin + ray.direction * ray.t_min, ray.time);
        }
    }

    void pass_through(Ray& ray, const SurfaceHit& hit)
    {
        travelled_ += hit.t;
        length_ += hit.t;
        media_.cross(hit);
        ray = passed_through(ray, hit);
    }

    // Through the media up to the next surface, if there is one: they shine, scatter light into
    // the ray and take from what is behind. True if the path is scattered before it gets there.
    bool fly(Ray& ray, std::optional<float> t_surface);

    void scatter(Ray& ray, const SurfaceHit& hit, const BsdfSample& sample);

    // Whether light counts that the path's ray finds. What only some objects block is left to
    // light sampling, which looks for these alone.
    [[nodiscard]] bool finds(const LightLinks& links) const
    {
        return path_.is_camera ||
               (links.lights(light_class_) && (links.blocker_set == 0 || last_->is_delta));
    }

    // Of shadow rays, through what is clear.
    [[nodiscard]] int passages_left() const
    {
        return settings_.limits.transparent_bounces - path_.transparent_depth;
    }

    // False if the path ends here.
    bool survives_roulette(float u);

    const Scene& scene_;
    const IntegratorSettings& settings_;
    SampleSequence& sequence_;
    PathLight light_;
    Color3f throughput_{1.0f};
    LastScattering last_;
    float travelled_ = 0.0f;  // from the last scattering, through straight passages
    float length_ = 0.0f;     // of all of the path
    PathState path_;
    MediumStack media_;
    int boundaries_ = 0;
    int light_class_ = light_class_of_media;  // of what the path was last scattered by
    bool shows_film_ = true;  // nothing has come between it and the eye but what is clear
};

}  // namespace eye_render
