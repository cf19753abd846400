// Blender's Magic Texture: sines of sums of sines.

#pragma once

#include "base/vector.h"

namespace eye_render {

// `depth` is how often the waves are folded into each other, 0 to 10. Channels are in [0, 1].
[[nodiscard]] Color3f magic_texture(const V3f& p, float scale, int depth, float distortion);

}  // namespace eye_render
