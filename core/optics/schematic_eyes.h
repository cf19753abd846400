// Published schematic eyes: the vertex of the cornea at z = 0, published vitreous lengths, the
// stop at the front vertex of the lens.

#pragma once

#include "optics/lens_system.h"

namespace eye_render {

enum class SchematicEyeKind { Navarro, Arizona, LeGrand };

// Accommodation as the publications parametrise it. It is *not* what the eye does: Navarro's eye
// of nominally 1 D accommodates 1.2 or 1.3 D. 0 is the relaxed eye.
[[nodiscard]] LensSystem schematic_eye(SchematicEyeKind kind, double nominal_accommodation_d);

// How far the parameter may be taken before the surfaces become absurd.
[[nodiscard]] double max_nominal_accommodation_d(SchematicEyeKind kind);

}  // namespace eye_render
