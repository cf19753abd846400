// Blender's Noise Texture: a fractal, at a place moved about by further noise, for one value or
// for the three channels of a colour.

#pragma once

#include "base/vector.h"
#include "shading/procedural/fractal.h"

namespace eye_render {

struct Noise {
    Fractal fractal;  // a negative roughness counts as 0
    float distortion = 0.0f;
};

// `p` is in cells: already scaled. Both are finite; the colour's red is the value.
template <int D>
[[nodiscard]] float noise_value(const Point<D>& p, const Noise& noise);
template <int D>
[[nodiscard]] V3f noise_color(const Point<D>& p, const Noise& noise);

extern template float noise_value(const Point<1>& p, const Noise& noise);
extern template float noise_value(const Point<2>& p, const Noise& noise);
extern template float noise_value(const Point<3>& p, const Noise& noise);
extern template float noise_value(const Point<4>& p, const Noise& noise);
extern template V3f noise_color(const Point<1>& p, const Noise& noise);
extern template V3f noise_color(const Point<2>& p, const Noise& noise);
extern template V3f noise_color(const Point<3>& p, const Noise& noise);
extern template V3f noise_color(const Point<4>& p, const Noise& noise);

}  // namespace eye_render
