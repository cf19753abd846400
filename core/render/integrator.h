// The path tracer: what radiance comes down one ray. It knows neither eye nor film.
//
// Unidirectional, next-event estimation and BSDF sampling weighed by the power heuristic (Veach
// 1997, 9.2), Russian roulette by throughput. Lamps are not seen by the first ray, as in Cycles.

#pragma once

#include "render/sample_sequence.h"
#include "scene/scene.h"

namespace eye_render {

struct IntegratorSettings {
    int max_bounces = 4;            // 0: what is lit directly; straight passages do not count
    bool film_transparent = false;  // the world lights the scene, but is not seen directly
    bool first_surface = false;     // normal and albedo are wanted
    // Width of a pixel at distance 1 along the view: what is finer is not seen by bump mapping.
    float pixel_slope = 0.0f;
};

struct PathRadiance {
    Color3f radiance{0.0f};
    float alpha = 1.0f;  // below 1 where a transparent film or a holdout shows
    // Of the first surface, on request: its normal in world space, turned to the eye, and its
    // albedo. Zero without a surface.
    V3f normal{0.0f};
    Color3f albedo{0.0f};
};

// Finite for every scene: what is not a number counts as no light.
[[nodiscard]] PathRadiance trace_path(const Scene& scene,
                                      const IntegratorSettings& settings,
                                      const Ray& camera_ray,
                                      SampleSequence& sequence);

}  // namespace eye_render
