// What the functions of ggx_surface.h share: a lobe for a surface, and its compensation.

#pragma once

#include "shading/energy_tables.h"
#include "shading/ggx_surface.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

[[nodiscard]] inline Lobe surface_lobe(LobeKind kind,
                                       const Color3f& weight,
                                       const GgxSurface& surface)
{
    const float alpha = surface.roughness * surface.roughness;
    Lobe lobe = plain_lobe(kind, weight, surface.normal, alpha);
    lobe.facets = surface.facets;
    if (surface.stretch_x != surface.stretch_y) {
        lobe.alpha_x = std::min(alpha * surface.stretch_x, 1.0f);
        lobe.alpha_y = std::min(alpha * surface.stretch_y, 1.0f);
        lobe.tangent = surface.tangent;
    }
    return lobe;
}

// Of the isotropic surface that stands for a brushed one in the tables.
[[nodiscard]] inline float table_roughness(const Lobe& lobe, const GgxSurface& surface)
{
    return lobe.alpha_x == lobe.alpha_y ? surface.roughness
                                        : std::sqrt(std::sqrt(lobe.alpha_x * lobe.alpha_y));
}

struct Compensation {
    Color3f factor{1.0f};
    Color3f albedo{1.0f};  // of the lobe without its Fresnel
};

[[nodiscard]] inline Compensation compensate(const LobeEnergy& energy, const Color3f& mean_fresnel)
{
    const Color3f factor = energy_compensation(energy, mean_fresnel);
    return {factor, factor * energy.albedo};
}

[[nodiscard]] inline bool is_compensated(const Lobe& lobe, const GgxSurface& surface)
{
    // A mirror loses nothing.
    return surface.multiple_scattering && surface.facets == FacetModel::Ggx && !lobe.is_delta();
}

// For a reflecting lobe.
[[nodiscard]] inline Compensation compensate(const Lobe& lobe,
                                             const GgxSurface& surface,
                                             const Color3f& mean_fresnel)
{
    return is_compensated(lobe, surface)
               ? compensate(reflection_energy(table_roughness(lobe, surface), surface.cos_o),
                            mean_fresnel)
               : Compensation{};
}

}  // namespace eye_render
