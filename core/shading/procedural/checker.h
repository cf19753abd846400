// Blender's Checker Texture: cubes of side 1, every other one set.

#pragma once

#include "base/vector.h"

namespace eye_render {

// `p` is already scaled.
[[nodiscard]] bool checker_texture(const V3f& p);

}  // namespace eye_render
