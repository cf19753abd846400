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

// The part of the way from reflectance `f0` at normal incidence to 1 that `reflectance` has gone:
// for reflection that is tinted at normal incidence and white at grazing.
[[nodiscard]] inline float dielectric_blend(float reflectance, float f0)
{
    return std::clamp((reflectance - f0) / (1.0f - f0), 0.0f, 1.0f);
}

// Schlick's approximation with a dip near 82 degrees, where real metals have their colour: Kutz,
// Hasan & Edmondson 2021, "Novel aspects of the Adobe Standard Material". `edge` is of
// f82_edge.
[[nodiscard]] inline Color3f f82_fresnel(float cos_incident,
                                         const Color3f& f0,
                                         const Color3f& edge)
{
    const float m = std::clamp(1.0f - cos_incident, 0.0f, 1.0f);
    const float m2 = m * m;
    const float m5 = m2 * m2 * m;
    const Color3f f = blend_to_white(f0, m5) - edge * (cos_incident * m5 * m);
    return {std::clamp(f.x, 0.0f, 1.0f), std::clamp(f.y, 0.0f, 1.0f), std::clamp(f.z, 0.0f, 1.0f)};
}

// The edge for which Schlick's reflectance at a cosine of 1/7 is `tint` times what it was.
[[nodiscard]] inline Color3f f82_edge(const Color3f& f0, const Color3f& tint)
{
    constexpr float m = 6.0f / 7.0f;
    constexpr float m5 = m * m * m * m * m;
    return blend_to_white(f0, m5) * (7.0f / (m5 * m)) * (Color3f(1.0f) - tint);
}

// Cosine-weighted mean of f82_fresnel over the hemisphere, but for its clamp.
[[nodiscard]] inline Color3f mean_f82_fresnel(const Color3f& f0, const Color3f& edge)
{
    return blend_to_white(f0, mean_schlick_blend) - edge * (1.0f / 126.0f);
}

// A metal of complex index n + i k, for an index well above 1 (Pharr & Humphreys 2004, "Physically
// Based Rendering", eq. 9.5).
[[nodiscard]] inline Color3f fresnel_conductor(float cos_incident,
                                               const Color3f& n,
                                               const Color3f& k)
{
    const float cos2 = cos_incident * cos_incident;
    const Color3f one(1.0f);
    const Color3f nk2 = n * n + k * k;
    const Color3f n_cos = n * (2.0f * cos_incident);
    const Color3f parallel = (nk2 * cos2 - n_cos + one) / (nk2 * cos2 + n_cos + one);
    const Color3f across = (nk2 - n_cos + Color3f(cos2)) / (nk2 + n_cos + Color3f(cos2));
    return (parallel + across) * 0.5f;
}

}  // namespace eye_render
