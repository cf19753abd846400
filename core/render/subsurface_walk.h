// A random walk below a surface until it meets its object again, from within or not: Chiang, Kutz
// & Burley 2016, "Practical and Controllable Subsurface Scattering for Production Path Tracing".
// Flights are drawn for the three channels together, and by three ways to choose directions, each
// weighed by what it matters (one-sample multiple importance sampling).

#pragma once

#include "render/subsurface.h"

namespace eye_render {

// As sample_exit, of a random walk on a mesh.
[[nodiscard]] std::optional<SubsurfaceExit> walk_below(const Scene& scene,
                                                       const SurfaceHit& entry,
                                                       const Lobe& lobe,
                                                       const Color3f& throughput,
                                                       SampleSequence& sequence);

}  // namespace eye_render
