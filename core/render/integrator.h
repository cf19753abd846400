// The path tracer: what radiance comes down one ray. It knows neither eye nor film.
//
// Unidirectional, next-event estimation and BSDF sampling weighed by the power heuristic (Veach
// 1997, 9.2), Russian roulette by throughput.

#pragma once

#include "render/light_path_limits.h"
#include "render/path_light.h"
#include "render/sample_sequence.h"
#include "render/surface_passes.h"
#include "scene/scene.h"

namespace eye_render {

struct IntegratorSettings {
    int max_bounces = 4;  // 0: what is lit directly; straight passages do not count
    LightPathLimits limits{};
    bool film_transparent = false;  // the world lights the scene, but is not seen directly
    // With a transparent film, glass is as clear as the film where the product of its two
    // microfacet alphas, its roughness to the fourth, is at most this; below 0 no glass is.
    float clear_alpha_squared = -1.0f;
    SurfacePassSettings surface_passes{};
    // Width of a pixel at distance 1 along the view: what is finer is not seen by bump mapping.
    float pixel_slope = 0.0f;
};

// Finite for every scene: what is not a number counts as no light. What passes other than Combined
// want is added to `values`, if there are any.
[[nodiscard]] PathRadiance trace_path(const Scene& scene,
                                      const IntegratorSettings& settings,
                                      const Ray& camera_ray,
                                      SampleSequence& sequence,
                                      PassValues* values = nullptr);

}  // namespace eye_render
