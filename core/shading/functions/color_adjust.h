// Adjustments of a colour: the nodes Hue/Saturation/Value, Brightness/Contrast, Gamma and Invert.

#pragma once

#include "base/vector.h"
#include "shading/functions/color_models.h"
#include "shading/functions/safe_math.h"

namespace eye_render {

[[nodiscard]] inline Color3f not_negative(const Color3f& c)
{
    return {c.x > 0.0f ? c.x : 0.0f, c.y > 0.0f ? c.y : 0.0f, c.z > 0.0f ? c.z : 0.0f};
}

[[nodiscard]] inline Color3f clamp_to_unit(const Color3f& c)
{
    return {clamp_to_unit(c.x), clamp_to_unit(c.y), clamp_to_unit(c.z)};
}

struct HueSaturationValue {
    float hue = 0.5f;  // half a turn is none
    float saturation = 1.0f;
    float value = 1.0f;
};

// `factor` is the share of the adjusted colour; what is over-saturated loses its negative parts.
[[nodiscard]] inline Color3f adjust_hsv(const Color3f& rgb,
                                        const HueSaturationValue& by,
                                        float factor)
{
    const V3f hsv = hsv_from_rgb(rgb);
    const Color3f adjusted = rgb_from_hsv(
        {fraction(hsv.x + by.hue + 0.5f), clamp_to_unit(hsv.y * by.saturation), hsv.z * by.value});
    return not_negative(adjusted * factor + rgb * (1.0f - factor));
}

// Contrast turns about middle grey.
[[nodiscard]] inline Color3f adjust_contrast(const Color3f& rgb, float brightness, float contrast)
{
    return not_negative(rgb * (1.0f + contrast) + Color3f(brightness - contrast * 0.5f));
}

// Negative channels stay as they are; an exponent of 0 makes white of everything.
[[nodiscard]] inline Color3f adjust_gamma(const Color3f& rgb, float exponent)
{
    if (exponent == 0.0f) {
        return Color3f(1.0f);
    }
    const auto channel = [&](float x) { return x > 0.0f ? std::pow(x, exponent) : x; };
    return {channel(rgb.x), channel(rgb.y), channel(rgb.z)};
}

[[nodiscard]] inline Color3f invert(const Color3f& rgb, float factor)
{
    return (Color3f(1.0f) - rgb) * factor + rgb * (1.0f - factor);
}

}  // namespace eye_render
