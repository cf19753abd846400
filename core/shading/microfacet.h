// Distributions of microfacet normals with Smith masking: GGX and Beckmann.
//
// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 25 to 34,
// with the height-correlated masking and shadowing, and the anisotropy, of Heitz 2014,
// "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 86 and 99. `alpha`
// is Blender's roughness squared. Cosines are against the macroscopic normal and are those of
// visible sides: 0 to 1. Local frames have that normal as z, and alpha_x along x.

#pragma once

#include "base/vector.h"

#include <cmath>
#include <numbers>

namespace eye_render {

// Below this alpha a lobe is a mirror: floats no longer resolve it, and no picture shows it.
// As in Cycles, where it is a limit of 5e-7 on alpha squared.
inline constexpr float smallest_rough_alpha = 7.07e-4f;

// Density of microfacet normals per unit solid angle and unit macroscopic area. The sine is asked
// for as well because its square cannot be had from the cosine's for a narrow lobe.
[[nodiscard]] inline float ggx_density(float alpha2, float cos2_m, float sin2_m)
{
    const float q = sin2_m + alpha2 * cos2_m;
    return alpha2 * std::numbers::inv_pi_v<float> / (q * q);
}

// The same of a local normal for facets that are spread more widely one way.
[[nodiscard]] inline float ggx_density(float alpha_x, float alpha_y, const V3f& m)
{
    const float x = m.x / alpha_x;
    const float y = m.y / alpha_y;
    const float q = x * x + y * y + m.z * m.z;
    return std::numbers::inv_pi_v<float> / (alpha_x * alpha_y * q * q);
}

[[nodiscard]] inline float beckmann_density(float alpha_x, float alpha_y, const V3f& m)
{
    const float x = m.x / alpha_x;
    const float y = m.y / alpha_y;
    const float cos2 = m.z * m.z;
    if (!(cos2 > 0.0f)) {
        return 0.0f;
    }
    return std::exp(-(x * x + y * y) / cos2) * std::numbers::inv_pi_v<float> /
           (alpha_x * alpha_y * cos2 * cos2);
}

// cos * (1 + 2 Lambda(cos)): Smith's Lambda in a form that stays finite at grazing angles.
[[nodiscard]] inline float smith_term(float alpha2, float cos_theta)
{
    return std::sqrt(alpha2 + (1.0f - alpha2) * cos_theta * cos_theta);
}

[[nodiscard]] inline float smith_term(float alpha_x, float alpha_y, const V3f& v)
{
    const float x = alpha_x * v.x;
    const float y = alpha_y * v.y;
    return std::sqrt(x * x + y * y + v.z * v.z);
}

[[nodiscard]] inline float beckmann_smith_term(float alpha_x, float alpha_y, const V3f& v)
{
    const float spread = std::hypot(alpha_x * v.x, alpha_y * v.y);
    const float a = v.z / spread;
    // Beyond it the error function is 1 to a float's last digit; infinite for a view from above.
    constexpr float large = 4.0f;
    if (!(a < large)) {
        return v.z;
    }
    return v.z * std::erf(a) + spread * std::exp(-a * a) * std::numbers::inv_sqrtpi_v<float>;
}

// G1(o) / cos_o, where G1 = 1 / (1 + Lambda).
[[nodiscard]] inline float masking_over_cos(float cos_o, float smith_o)
{
    return 2.0f / (cos_o + smith_o);
}

// G2(o, i) / cos_o, where G2 = 1 / (1 + Lambda(o) + Lambda(i)).
[[nodiscard]] inline float masking_shadowing_over_cos(float cos_o,
                                                      float smith_o,
                                                      float cos_i,
                                                      float smith_i)
{
    return 2.0f * cos_i / (smith_o * cos_i + smith_i * cos_o);
}

// A GGX normal with density D(m) G1(wo) max(0, wo.m) / wo.z per unit solid angle: by spherical
// caps, Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps". Local frame,
// wo.z > 0.
[[nodiscard]] V3f sample_visible_normal(const V3f& wo_local,
                                        float alpha_x,
                                        float alpha_y,
                                        const V2f& u);

[[nodiscard]] inline V3f sample_visible_normal(const V3f& wo_local, float alpha, const V2f& u)
{
    return sample_visible_normal(wo_local, alpha, alpha, u);
}

// The same for Beckmann's distribution: Heitz & d'Eon 2014, "Importance Sampling Microfacet-Based
// BSDFs using the Distribution of Visible Normals", section 5.
[[nodiscard]] V3f sample_visible_beckmann_normal(const V3f& wo_local,
                                                 float alpha_x,
                                                 float alpha_y,
                                                 const V2f& u);

}  // namespace eye_render
