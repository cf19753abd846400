// How a path looks at what lights a surface: not the camera's own ray.

#pragma once

#include "shading/node.h"

namespace eye_render {

inline constexpr PathState light_path{.is_camera = false, .depth = 1};

// And at what stands between the two.
inline constexpr PathState shadow_path{.is_camera = false, .is_shadow = true};

}  // namespace eye_render
