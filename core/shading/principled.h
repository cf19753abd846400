// Blender's Principled BSDF, version 2 (Blender 4.0 and later), for the inputs of Material.

#pragma once

#include "shading/material.h"

namespace eye_render {

[[nodiscard]] ShadedPoint shade_principled(const Material& material,
                                           const ShadingPoint& point,
                                           const HitAttributes& attributes);

}  // namespace eye_render
