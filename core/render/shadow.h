// What stands between a surface and a light.

#pragma once

#include "scene/scene.h"

namespace eye_render {

// The part of the light that reaches the surface: 0 behind an opaque one. `path` is that of the
// hit, and so are the media on the viewer's side of the surface; `most_passages` is for
// Scene::transmittance.
[[nodiscard]] Color3f unshadowed(const Scene& scene,
                                 const SurfaceHit& hit,
                                 const IncomingLight& light,
                                 const PathState& path,
                                 int most_passages,
                                 const MediumStack& media);

}  // namespace eye_render
