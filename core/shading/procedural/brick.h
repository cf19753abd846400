// Blender's Brick Texture: rows of bricks in the XY plane, mortar between them.

#pragma once

#include "base/vector.h"

namespace eye_render {

struct Brick {
    float mortar_size = 0.02f;   // half the gap between bricks, in scaled units
    float mortar_smooth = 0.1f;  // how much of the mortar is a transition, 0 to 1
    float bias = 0.0f;           // of the tint
    float brick_width = 0.5f;
    float row_height = 0.25f;
    float offset = 0.5f;  // of every `offset_frequency`-th row, in bricks
    int offset_frequency = 2;
    float squash = 1.0f;  // width of the bricks of every `squash_frequency`-th row
    int squash_frequency = 2;
};

// Both in [0, 1].
struct BrickAnswer {
    float tint = 0.0f;    // of the brick, from its first to its second colour
    float mortar = 0.0f;  // 1 within it
};

// `p` is already scaled; frequencies are positive.
[[nodiscard]] BrickAnswer brick_texture(const V3f& p, const Brick& brick);

}  // namespace eye_render
