// Where light that enters below a surface comes out of the same object.

#pragma once

#include "render/sample_sequence.h"
#include "scene/scene.h"

namespace eye_render {

struct SubsurfaceExit {
    SurfaceHit hit;  // seen from outside
    Color3f throughput;
};

// Draws an exit for a path that enters where it hit an object, by a subsurface lobe of the mixture
// there; `throughput` has the lobe's weight in it. Nothing if its light is absorbed or lost.
[[nodiscard]] std::optional<SubsurfaceExit> sample_exit(const Scene& scene,
                                                        const SurfaceHit& entry,
                                                        const Lobe& lobe,
                                                        const Color3f& throughput,
                                                        SampleSequence& sequence);

// How light leaves there: as from a white Lambert surface, whatever the material is.
[[nodiscard]] Bsdf exit_bsdf(const Scene& scene, const SurfaceHit& exit, const PathState& path);

}  // namespace eye_render
