// How many octaves a texture has. Blender's Detail counts those after the first and need not be
// whole: its fraction is how much of one more is blended in.

#pragma once

#include "shading/procedural/safe_float.h"

#include <cmath>

namespace eye_render {

struct Octaves {
    int whole;   // after the first
    float part;  // of one more, in [0, 1)
};

// Blender has at most 15; NaN counts as 0.
[[nodiscard]] inline Octaves octaves_of(float detail)
{
    constexpr float most_detail = 15.0f;
    const float clamped = in_range(detail, 0.0f, most_detail);
    const float whole = std::floor(clamped);
    return {static_cast<int>(whole), clamped - whole};
}

}  // namespace eye_render
