// Blender's Gradient Texture.

#pragma once

#include "base/vector.h"

#include <cstdint>

namespace eye_render {

enum class GradientType : std::uint8_t {
    Linear,
    Quadratic,
    Easing,
    Diagonal,
    Spherical,
    QuadraticSphere,
    Radial,
};

// In [0, 1].
[[nodiscard]] float gradient_texture(const V3f& p, GradientType type);

}  // namespace eye_render
