// The normals that lobes are built around. World space, unit.

#pragma once

#include "shading/material.h"

namespace eye_render {

// The interpolated normal, turned by the material's normal map where it has one: tangent space,
// green up, as Blender's Normal Map node. Towards the viewer as `point.ns` is.
[[nodiscard]] V3f mapped_normal(const Material& material,
                                const ShadingPoint& point,
                                const HitAttributes& attributes);

// `normal`, bent as little as it takes for the mirror direction of wo to leave the surface:
// interpolated and mapped normals may turn it below the geometry, or face away from the viewer,
// and a mirror would be black there. By the lifted mirror direction of Keller et al. 2017, "The
// Iray Light Transport Simulation and Rendering System".
[[nodiscard]] V3f visible_normal(const V3f& normal, const ShadingPoint& point);

}  // namespace eye_render
