// The isotropic GGX distribution of microfacet normals with Smith masking.
//
// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 33 and 34,
// with the height-correlated masking and shadowing of Heitz 2014, "Understanding the
// Masking-Shadowing Function in Microfacet-Based BRDFs", eq. 99. `alpha` is Blender's roughness
// squared. Cosines are against the macroscopic normal and are those of visible sides: 0 to 1.

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

// cos * (1 + 2 Lambda(cos)): Smith's Lambda in a form that stays finite at grazing angles.
[[nodiscard]] inline float smith_term(float alpha2, float cos_theta)
{
    return std::sqrt(alpha2 + (1.0f - alpha2) * cos_theta * cos_theta);
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

// A normal with density D(m) G1(wo) max(0, wo.m) / wo.z per unit solid angle: by spherical caps,
// Dupuy & Benyoub 2023, "Sampling Visible GGX Normals with Spherical Caps". Local frame, wo.z > 0.
[[nodiscard]] V3f sample_visible_normal(const V3f& wo_local, float alpha, const V2f& u);

}  // namespace eye_render
