// Perlin's gradient noise (Perlin 2002, "Improving Noise") in one to four dimensions, with the
// hash, the gradients and the scale that Blender has from Open Shading Language.

#pragma once

#include "shading/procedural/point.h"

namespace eye_render {

// In about [-1, 1], 0 at whole numbers, with continuous second derivatives. Repeats every
// 100,000 units, where it jumps, since floats far away cannot tell cells apart; 0 where a
// coordinate is not finite.
template <int D>
[[nodiscard]] float perlin_noise(const Point<D>& p);

extern template float perlin_noise(const Point<1>& p);
extern template float perlin_noise(const Point<2>& p);
extern template float perlin_noise(const Point<3>& p);
extern template float perlin_noise(const Point<4>& p);

}  // namespace eye_render
