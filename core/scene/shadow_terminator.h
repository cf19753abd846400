// Where light turns the corner of a mesh of few smooth faces, its edges throw shadows that the
// round surface it stands for would not. Shadow rays start from near that surface instead: a
// parabolic approximation of it, within the linear envelope of the corners' tangent planes, as in
// Cycles.

#pragma once

#include "scene/surface_hit.h"

namespace eye_render {

// From the hit to where a shadow ray in the unit direction `wi` starts, in world space; zero but
// close to the terminator, within the placement's `terminator_cosine`, of smooth triangles.
[[nodiscard]] V3f terminator_offset(const SurfaceHit& hit, const V3f& wi);

}  // namespace eye_render
