// What a path becomes where a surface scatters it, and where its bounces end.

#pragma once

#include "render/light_path_limits.h"
#include "shading/node.h"

namespace eye_render {

inline void note_scattering(PathState& path,
                            const BsdfSample& sample,
                            const LightPathLimits& limits)
{
    path.is_camera = false;
    path.is_diffuse = sample.is_diffuse;
    path.is_glossy = !sample.is_diffuse;
    path.is_singular = sample.is_delta;
    path.is_transmission = sample.is_transmitted;
    path.is_reflection = !sample.is_transmitted;
    path.shows_reflections = limits.reflective_caustics || !sample.is_diffuse;
    path.shows_refractions = limits.refractive_caustics || !sample.is_diffuse;
    ++path.depth;
    if (sample.is_transmitted) {
        ++path.transmission_depth;
    } else if (sample.is_diffuse) {
        ++path.diffuse_depth;
    } else {
        ++path.glossy_depth;
    }
}

// True for the ray after the last bounce, which only finds what shines by itself.
[[nodiscard]] inline bool had_last_bounce(const PathState& path,
                                          int max_bounces,
                                          const LightPathLimits& limits)
{
    return path.depth > max_bounces || path.diffuse_depth > limits.diffuse_bounces ||
           path.glossy_depth > limits.glossy_bounces ||
           path.transmission_depth > limits.transmission_bounces;
}

}  // namespace eye_render
