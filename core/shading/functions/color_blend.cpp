#include "shading/functions/color_blend.h"

#include "shading/functions/color_models.h"
#include "shading/functions/named_rows.h"
#include "shading/functions/safe_math.h"

#include <array>

namespace eye_render {

namespace {

// Each channel for itself.
template <float (*channel)(float t, float a, float b)>
Color3f each(float t, const Color3f& a, const Color3f& b)
{
    return {channel(t, a.x, b.x), channel(t, a.y, b.y), channel(t, a.z, b.z)};
}

[[nodiscard]] float part_way(float t, float a, float b) { return a + t * (b - a); }
[[nodiscard]] Color3f part_way(float t, const Color3f& a, const Color3f& b)
{
    return a + (b - a) * t;
}

float mix(float t, float a, float b) { return part_way(t, a, b); }
float darken(float t, float a, float b) { return part_way(t, a, a < b ? a : b); }
float lighten(float t, float a, float b) { return part_way(t, a, a > b ? a : b); }
float multiply(float t, float a, float b) { return part_way(t, a, a * b); }
float add(float t, float a, float b) { return part_way(t, a, a + b); }
float subtract(float t, float a, float b) { return part_way(t, a, a - b); }
float difference(float t, float a, float b) { return part_way(t, a, std::abs(a - b)); }
float linear_light(float t, float a, float b) { return a + t * (2.0f * b - 1.0f); }

float divide(float t, float a, float b) { return b != 0.0f ? (1.0f - t) * a + t * a / b : a; }

float exclusion(float t, float a, float b)
{
    const float mixed = part_way(t, a, a + b - 2.0f * a * b);
    return mixed > 0.0f ? mixed : 0.0f;
}

float screen(float t, float a, float b) { return 1.0f - (1.0f - t + t * (1.0f - b)) * (1.0f - a); }

float overlay(float t, float a, float b)
{
    return a < 0.5f ? a * (1.0f - t + 2.0f * t * b)
                    : 1.0f - (1.0f - t + 2.0f * t * (1.0f - b)) * (1.0f - a);
}

float soft_light(float t, float a, float b)
{
    const float screened = 1.0f - (1.0f - b) * (1.0f - a);
    return (1.0f - t) * a + t * ((1.0f - a) * b * a + a * screened);
}

float dodge(float t, float a, float b)
{
    if (a == 0.0f) {
        return a;
    }
    const float rest = 1.0f - t * b;
    if (rest <= 0.0f) {
        return 1.0f;
    }
    const float dodged = a / rest;
    return dodged > 1.0f ? 1.0f : dodged;
}

float burn(float t, float a, float b)
{
    const float rest = 1.0f - t + t * b;
    return rest <= 0.0f ? 0.0f : clamp_to_unit(1.0f - (1.0f - a) / rest);
}

// The models below leave `a` where a grey has no hue to give or take.
Color3f hue(float t, const Color3f& a, const Color3f& b)
{
    const V3f giver = hsv_from_rgb(b);
    if (giver.y == 0.0f) {
        return a;
    }
    const V3f taker = hsv_from_rgb(a);
    return part_way(t, a, rgb_from_hsv({giver.x, taker.y, taker.z}));
}

Color3f saturation(float t, const Color3f& a, const Color3f& b)
{
    const V3f taker = hsv_from_rgb(a);
    if (taker.y == 0.0f) {
        return a;
    }
    const float mixed = (1.0f - t) * taker.y + t * hsv_from_rgb(b).y;
    return rgb_from_hsv({taker.x, mixed, taker.z});
}

Color3f color(float t, const Color3f& a, const Color3f& b)
{
    const V3f giver = hsv_from_rgb(b);
    if (giver.y == 0.0f) {
        return a;
    }
    return part_way(t, a, rgb_from_hsv({giver.x, giver.y, hsv_from_rgb(a).z}));
}

Color3f value(float t, const Color3f& a, const Color3f& b)
{
    const V3f taker = hsv_from_rgb(a);
    const float mixed = (1.0f - t) * taker.z + t * hsv_from_rgb(b).z;
    return rgb_from_hsv({taker.x, taker.y, mixed});
}

constexpr std::array<ColorBlend, 19> blends{{
    {"MIX", each<mix>},
    {"DARKEN", each<darken>},
    {"MULTIPLY", each<multiply>},
    {"BURN", each<burn>},
    {"LIGHTEN", each<lighten>},
    {"SCREEN", each<screen>},
    {"DODGE", each<dodge>},
    {"ADD", each<add>},
    {"OVERLAY", each<overlay>},
    {"SOFT_LIGHT", each<soft_light>},
    {"LINEAR_LIGHT", each<linear_light>},
    {"DIFFERENCE", each<difference>},
    {"EXCLUSION", each<exclusion>},
    {"SUBTRACT", each<subtract>},
    {"DIVIDE", each<divide>},
    {"HUE", hue},
    {"SATURATION", saturation},
    {"COLOR", color},
    {"VALUE", value},
}};

}  // namespace

const ColorBlend& color_blend(std::string_view name)
{
    return row_named(std::span<const ColorBlend>(blends), "blend_type", name);
}

}  // namespace eye_render
