// The blend types of the Mix node, under Blender's names: `a` with a share `t` of what `b` makes
// of it.

#pragma once

#include "base/vector.h"

#include <string_view>

namespace eye_render {

struct ColorBlend {
    std::string_view name;
    Color3f (*apply)(float t, const Color3f& a, const Color3f& b) = nullptr;
};

// Throws std::invalid_argument for a name that is none.
[[nodiscard]] const ColorBlend& color_blend(std::string_view name);

}  // namespace eye_render
