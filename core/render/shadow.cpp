#include "render/shadow.h"

#include "scene/shadow_terminator.h"

#include <cmath>

namespace eye_render {

namespace {

// From clear of the surface to the light's own place: a ray that kept the direction from the
// surface would miss that place by the offset.
Ray shadow_ray(const SurfaceHit& hit, const IncomingLight& light)
{
    Ray ray = hit.ray_towards(light.wi);
    ray.origin += terminator_offset(hit, light.wi);
    if (std::isfinite(light.distance)) {
        const V3f to_light = hit.p_world + light.wi * light.distance - ray.origin;
        ray.t_max = to_light.length();
        ray.direction = to_light / ray.t_max;
    }
    return ray;
}

}  // namespace

Color3f unshadowed(const Scene& scene,
                   const SurfaceHit& hit,
                   const IncomingLight& light,
                   const PathState& path,
                   int most_passages,
                   const MediumStack& media)
{
    if (!light.casts_shadow) {
        return Color3f(1.0f);
    }
    const Ray ray = shadow_ray(hit, light);
    if (!scene.has_media()) {
        return scene.transmittance(ray, path, most_passages, nullptr, light.links.blocker_set);
    }
    MediumStack passed = media;
    if (light.wi.dot(hit.point.ng) < 0.0f) {
        passed.cross(hit);
    }
    return scene.transmittance(ray, path, most_passages, &passed, light.links.blocker_set);
}

}  // namespace eye_render
