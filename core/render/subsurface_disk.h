// Light that leaves a surface around where it entered, by Christensen and Burley's profile: the
// surfaces of the object along a disk ray are its exits, as Cycles looks for them.

#pragma once

#include "render/subsurface.h"

namespace eye_render {

// As sample_exit, of Burley on a mesh.
[[nodiscard]] std::optional<SubsurfaceExit> sample_disk_exit(const Scene& scene,
                                                             const SurfaceHit& entry,
                                                             const Lobe& lobe,
                                                             const Color3f& throughput,
                                                             SampleSequence& sequence);

}  // namespace eye_render
