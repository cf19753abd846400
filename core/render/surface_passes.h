// What the surfaces that the camera sees tell of themselves, whatever light falls on them.

#pragma once

#include "render/pass_layout.h"
#include "scene/surface_hit.h"

namespace eye_render {

// Adds what one surface along the camera's ray tells, by how much of it is seen: `throughput` is
// what those before it let pass, and what it lets pass itself is left to those behind.
void note_surface(PassValues& values,
                  const SurfaceHit& hit,
                  const ShadedPoint& shaded,
                  const Color3f& throughput);

}  // namespace eye_render
