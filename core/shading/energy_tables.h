// How much light the GGX lobes return, from tables, and the factor that gives back what single
// scattering loses.
//
// A microfacet model that follows one bounce loses the light that would leave after more. As in
// Cycles since Blender 4.0 the lobe is scaled by 1/E, its directional albedo without Fresnel
// (Turquin 2019, "Practical Multiple Scattering Compensation for Microfacet Models"), and coloured
// by the Fresnel of the bounces in between (Kulla & Conty 2017, "Revisiting Physically Based
// Shading at Imageworks"). The grids, their parameters and the linear interpolation are those of
// Cycles, so that both err alike between the nodes. `roughness` is Blender's, alpha its square;
// `cos_o` is of the viewer. Both are clamped to [0, 1].
//
// The tables are computed when they are first asked for, some tens of milliseconds each set.

#pragma once

#include "base/vector.h"

namespace eye_render {

// Of a lobe that absorbs nothing but what single scattering loses.
struct LobeEnergy {
    float albedo = 1.0f;       // seen under one angle
    float mean_albedo = 1.0f;  // cosine-weighted over all angles
};

[[nodiscard]] LobeEnergy reflection_energy(float roughness, float cos_o);
// Reflection and transmission together, with the exact dielectric Fresnel.
[[nodiscard]] LobeEnergy glass_energy(float roughness, float cos_o, float ior);

// Factor on a lobe whose Fresnel, or colour, has the cosine-weighted mean `mean_fresnel`.
[[nodiscard]] Color3f energy_compensation(const LobeEnergy& energy, const Color3f& mean_fresnel);
[[nodiscard]] float energy_compensation(const LobeEnergy& energy, float mean_fresnel);

// How far the mean Fresnel of the facets that are seen has moved from `f0` to white: for a
// dielectric, and for Schlick's Fresnel. Facets that reflect below the surface count as 0.
[[nodiscard]] float dielectric_albedo_blend(float roughness, float cos_o, float ior);
[[nodiscard]] float schlick_albedo_blend(float roughness, float cos_o);

}  // namespace eye_render
