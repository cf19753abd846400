// Fresnel reflectance at a smooth boundary, unpolarised. `ior` is relative: that of the far side
// over that of the near side, where the light comes from; angles are on the near side.

#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

struct DielectricFresnel {
    float reflectance = 1.0f;
    float cos_transmitted = 0.0f;  // 0 in total internal reflection
};

// Exact. `cos_incident` in [0, 1], `ior` > 0.
[[nodiscard]] inline DielectricFresnel fresnel_dielectric(float cos_incident, float ior)
{
    const float cos2_transmitted = 1.0f - (1.0f - cos_incident * cos_incident) / (ior * ior);
    if (!(cos2_transmitted > 0.0f)) {
        return {};
    }
    const float cos_transmitted = std::sqrt(cos2_transmitted);
    const float s =
        (cos_incident - ior * cos_transmitted) / (cos_incident + ior * cos_transmitted);
    const float p =
        (ior * cos_incident - cos_transmitted) / (ior * cos_incident + cos_transmitted);
    return {0.5f * (s * s + p * p), cos_transmitted};
}

// Reflectance at normal incidence.
[[nodiscard]] inline float f0_from_ior(float ior)
{
    const float amplitude = (ior - 1.0f) / (ior + 1.0f);
    return amplitude * amplitude;
}

// The index above 1 that has this reflectance. Reflectance 1 would need an infinite one, so it is
// cut off below.
[[nodiscard]] inline float ior_from_f0(float f0)
{
    constexpr float largest_f0 = 0.99f;
    const float amplitude = std::sqrt(std::clamp(f0, 0.0f, largest_f0));
    return (1.0f + amplitude) / (1.0f - amplitude);
}

// Cosine-weighted mean of fresnel_dielectric over the hemisphere: the fits of Kulla & Conty 2017,
// "Revisiting Physically Based Shading at Imageworks".
[[nodiscard]] inline float mean_fresnel_dielectric(float ior)
{
    if (ior < 1.0f) {
        return 0.997118f + ior * (0.1014f - ior * (0.965241f + ior * 0.130607f));
    }
    return (ior - 1.0f) / (4.08567f + 1.00071f * ior);
}

// How far Schlick's 1994 approximation has moved from `f0` to white: F = f0 + (1 - f0) * blend.
[[nodiscard]] inline float schlick_blend(float cos_incident)
{
    const float m = std::clamp(1.0f - cos_incident, 0.0f, 1.0f);
    const float m2 = m * m;
    return m2 * m2 * m;
}

// Cosine-weighted mean of schlick_blend over the hemisphere.
inline constexpr float mean_schlick_blend = 1.0f / 21.0f;

// From `f0` to white.
[[nodiscard]] inline Color3f blend_to_white(const Color3f& f0, float blend)
{
    return f0 + (Color3f(1.0f) - f0) * blend;
}

}  // namespace eye_render
