// Light found in two ways, by rays that a BSDF sends and by aiming at lights, and how the two are
// weighed (Veach 1997, 9.2). Densities are per unit solid angle.

#pragma once

#include "scene/scene.h"

#include <cmath>

namespace eye_render {

[[nodiscard]] inline float power_heuristic(float pdf, float other_pdf)
{
    // As a ratio, so that squares of large densities (the sun's is 1e5) cannot overflow.
    if (!(pdf > 0.0f)) {
        return 0.0f;
    }
    const float ratio = other_pdf / pdf;
    return 1.0f / (1.0f + ratio * ratio);
}

// The last place where the path was scattered, and how.
struct Scattering {
    LitPoint point;  // weighed unless is_delta
    float pdf = 0.0f;
    bool is_delta = true;  // the camera counts as one: no light sampling competes with its ray

    // Of light that the ray from here found and light sampling finds with `light_pdf`.
    [[nodiscard]] float weight_against(float light_pdf) const
    {
        return is_delta ? 1.0f : power_heuristic(pdf, light_pdf);
    }
};

// From clear of the surface to the light's own place: a ray that kept the direction from the
// surface would miss that place by the offset.
[[nodiscard]] inline Ray shadow_ray(const SurfaceHit& hit, const IncomingLight& light)
{
    Ray ray{.origin = hit.origin_towards(light.wi), .direction = light.wi, .time = hit.time};
    if (std::isfinite(light.distance)) {
        const V3f to_light = hit.p_world + light.wi * light.distance - ray.origin;
        ray.t_max = to_light.length();
        ray.direction = to_light / ray.t_max;
    }
    return ray;
}

}  // namespace eye_render
