// What a path becomes where a surface or a medium scatters it, and where its bounces end.

#pragma once

#include "render/light_path_limits.h"
#include "shading/node.h"

#include <algorithm>
#include <cmath>

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
    path.is_volume_scatter = false;
    path.shows_reflections = limits.reflective_caustics || !sample.is_diffuse;
    path.shows_refractions = limits.refractive_caustics || !sample.is_diffuse;
    if (!sample.is_delta) {
        path.smallest_pdf = std::min(path.smallest_pdf, sample.pdf);
    }
    ++path.depth;
    if (sample.is_transmitted) {
        ++path.transmission_depth;
    } else if (sample.is_diffuse) {
        ++path.diffuse_depth;
    } else {
        ++path.glossy_depth;
    }
}

// Blurs what the path meets by an unlikely bounce: what is sharp would be noise.
inline void blur_after(const PathState& path, const LightPathLimits& limits, Bsdf& bsdf)
{
    if (path.smallest_pdf < limits.filter_glossy) {
        bsdf.blur(0.5f * std::sqrt(1.0f - path.smallest_pdf / limits.filter_glossy));
    }
}

inline void note_medium_scattering(PathState& path, float pdf)
{
    path.smallest_pdf = std::min(path.smallest_pdf, pdf);
    path.is_camera = path.is_diffuse = path.is_glossy = path.is_singular = false;
    path.is_transmission = path.is_reflection = false;
    path.is_volume_scatter = true;
    path.shows_reflections = path.shows_refractions = true;
    ++path.depth;
    ++path.volume_depth;
}

// True for the ray after the last bounce, which only finds what shines by itself.
[[nodiscard]] inline bool had_last_bounce(const PathState& path,
                                          int max_bounces,
                                          const LightPathLimits& limits)
{
    return path.depth > max_bounces || path.diffuse_depth > limits.diffuse_bounces ||
           path.glossy_depth > limits.glossy_bounces ||
           path.transmission_depth > limits.transmission_bounces ||
           path.volume_depth > limits.volume_bounces;
}

// The probability with which a path of this throughput goes on. By its square root: paths are
// ended a little later than by the throughput alone, which matches how dark parts are displayed
// (as Cycles does).
[[nodiscard]] inline float roulette_survival(int depth, const Color3f& throughput)
{
    // Surfaces before roulette starts: the first two carry most of the picture.
    constexpr int roulette_start = 2;
    const float most = max_component(throughput);
    if (depth < roulette_start) {
        return most > 0.0f ? 1.0f : 0.0f;
    }
    return std::min(1.0f, std::sqrt(most));
}

}  // namespace eye_render
