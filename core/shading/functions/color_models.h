// Red, green, blue as hue, saturation and value (Smith 1978, "Color Gamut Transform Pairs") or
// lightness, and back. Hue is in turns; red is 0. Saturation of black is 0.

#pragma once

#include "base/vector.h"

namespace eye_render {

[[nodiscard]] V3f hsv_from_rgb(const Color3f& rgb);
[[nodiscard]] Color3f rgb_from_hsv(const V3f& hsv);  // a hue of 0 to 1

[[nodiscard]] V3f hsl_from_rgb(const Color3f& rgb);
[[nodiscard]] Color3f rgb_from_hsl(const V3f& hsl);  // a hue of 0 to 1

}  // namespace eye_render
