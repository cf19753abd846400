#include "shading/functions/color_models.h"

#include "shading/functions/safe_math.h"

namespace eye_render {

namespace {

struct Extremes {
    float least;
    float greatest;
    [[nodiscard]] float range() const { return greatest - least; }
};

// A channel that is not a number is never the greatest, but makes the least, and so the hue and
// the saturation, no number either.
[[nodiscard]] Extremes extremes(const Color3f& c)
{
    const float least = c.y < c.z ? c.y : c.z;
    return {c.x < least ? c.x : least, std::fmax(c.x, std::fmax(c.y, c.z))};
}

// In turns, 0 to 1, of each channel's distance below the greatest in parts of the range; that of
// the greatest itself is 0.
[[nodiscard]] float hue(const Color3f& rgb, float greatest, const V3f& below)
{
    float sixths = 0.0f;
    if (rgb.x == greatest) {
        sixths = below.z - below.y;
    } else if (rgb.y == greatest) {
        sixths = 2.0f + below.x - below.z;
    } else {
        sixths = 4.0f + below.y - below.x;
    }
    return sixths < 0.0f ? sixths / 6.0f + 1.0f : sixths / 6.0f;
}

}  // namespace

V3f hsv_from_rgb(const Color3f& rgb)
{
    const Extremes of = extremes(rgb);
    const float saturation = safe_divide(of.range(), of.greatest);
    if (saturation == 0.0f) {
        return {0.0f, 0.0f, of.greatest};
    }
    const V3f below = (Color3f(of.greatest) - rgb) / of.range();
    return {hue(rgb, of.greatest, below), saturation, of.greatest};
}

Color3f rgb_from_hsv(const V3f& hsv)
{
    const float saturation = hsv.y;
    const float value = hsv.z;
    if (saturation == 0.0f) {
        return Color3f(value);
    }
    // A whole turn is none.
    const float sixths = hsv.x == 1.0f ? 0.0f : hsv.x * 6.0f;
    const float sector = std::floor(sixths);
    const float rise = sixths - sector;
    const float low = value * (1.0f - saturation);
    const float falling = value * (1.0f - saturation * rise);
    const float rising = value * (1.0f - saturation * (1.0f - rise));
    if (sector == 0.0f) {
        return {value, rising, low};
    }
    if (sector == 1.0f) {
        return {falling, value, low};
    }
    if (sector == 2.0f) {
        return {low, value, rising};
    }
    if (sector == 3.0f) {
        return {low, falling, value};
    }
    if (sector == 4.0f) {
        return {rising, low, value};
    }
    // So does every hue out of range.
    return {value, low, falling};
}

V3f hsl_from_rgb(const Color3f& rgb)
{
    const Extremes of = extremes(rgb);
    const float sum = of.greatest + of.least;
    const float lightness = std::fmin(1.0f, sum / 2.0f);
    if (of.greatest == of.least) {
        return {0.0f, 0.0f, lightness};
    }
    const float saturation =
        lightness > 0.5f ? of.range() / (2.0f - of.greatest - of.least) : of.range() / sum;
    // A channel of infinite light has a hue, too.
    const V3f above = (rgb - Color3f(of.least)) / of.range();
    return {hue(rgb, of.greatest, -above), saturation, lightness};
}

Color3f rgb_from_hsl(const V3f& hsl)
{
    const float sixths = hsl.x * 6.0f;
    const float lightness = hsl.z;
    const float chroma = (1.0f - std::abs(2.0f * lightness - 1.0f)) * hsl.y;
    const auto channel = [&](float ramp) {
        return (clamp_to_unit(ramp) - 0.5f) * chroma + lightness;
    };
    return {channel(std::abs(sixths - 3.0f) - 1.0f), channel(2.0f - std::abs(sixths - 2.0f)),
            channel(2.0f - std::abs(sixths - 4.0f))};
}

}  // namespace eye_render
