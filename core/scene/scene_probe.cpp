#include "scene/scene_probe.h"

#include "base/sobol.h"
#include "scene/light_path.h"
#include "scene/scene.h"

#include <bit>

namespace eye_render {

bool Scene::is_blocked(const Ray& ray) const
{
    return accelerator_.occluded(ray, ray_mask(shadow_path));
}

void Scene::visit_object(const Ray& ray,
                         const Placement& placement,
                         const std::function<bool(const SurfaceHit&)>& visit) const
{
    Ray rest = ray;
    float travelled = 0.0f;
    for (int passages = 0; passages <= max_straight_passages; ++passages) {
        const auto found = accelerator_.intersect(rest);
        if (!found) {
            return;
        }
        const Placement& met = placements_[found->placement];
        Room<Pose> moved;
        SurfaceHit hit = make_surface_hit(rest, *found, met, pose_at(met, ray.time, moved),
                                          accelerator_.positions(found->placement));
        rest = passed_through(rest, hit);
        travelled += hit.t;
        hit.t = travelled;
        if (&met == &placement && !visit(hit)) {
            return;
        }
    }
}

std::optional<SurfaceHit> intersect_object(const Scene& scene,
                                           const Ray& ray,
                                           const Placement& object,
                                           std::optional<std::uint32_t> but)
{
    std::optional<SurfaceHit> nearest;
    scene.visit_object(ray, object, [&nearest, &but](const SurfaceHit& hit) {
        if (hit.primitive == but) {
            return true;
        }
        nearest = hit;
        return false;
    });
    return nearest;
}

bool SceneProbe::is_blocked(const V3f& direction, float distance, bool local) const
{
    Ray ray = hit_.ray_towards(direction);
    ray.t_max = distance;
    if (!local) {
        return scene_.is_blocked(ray);
    }
    return intersect_object(scene_, ray, *hit_.placement).has_value();
}

void SceneProbe::cross_own_object(const V3f& start,
                                  const V3f& direction,
                                  float length,
                                  const std::function<void(const Crossing&)>& visit) const
{
    const Ray ray{.origin = hit_.p_world + start,
                  .direction = direction,
                  .t_max = length,
                  .time = hit_.time};
    scene_.visit_object(ray, *hit_.placement, [&](const SurfaceHit& met) {
        visit({.from_hit = met.p_world - hit_.p_world,
               .ng = met.point.ng,
               .ns = met.point.backfacing ? -met.point.ns : met.point.ns});
        return true;
    });
}

std::uint64_t SceneProbe::seed() const
{
    std::uint64_t seed = 0;
    for (const V3f* v : {&hit_.p_world, &hit_.point.wo}) {
        for (int axis = 0; axis < 3; ++axis) {
            seed = sobol_key(seed, std::bit_cast<std::uint32_t>((*v)[axis]));
        }
    }
    return seed;
}

}  // namespace eye_render
