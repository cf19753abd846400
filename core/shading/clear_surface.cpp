// Weights and albedos of boundaries between clear media: polish, coat, glass and refraction.

#include "shading/energy_tables.h"
#include "shading/fresnel.h"
#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/lookup_table.h"
#include "shading/microfacet_lobe.h"
#include "shading/surface_lobe.h"

#include <algorithm>

namespace eye_render {

namespace {

[[nodiscard]] bool is_plain(const Boundary& boundary)
{
    return !(boundary.film_thickness_nm > 0.0f) && boundary.specular_tint == Color3f(1.0f);
}

// What tells a boundary that is tinted or has a film from one that is plain.
void tint(Lobe& lobe, const Boundary& boundary, LobeKind tinted)
{
    lobe.kind = tinted;
    lobe.f0 = unit_range(boundary.specular_tint * f0_from_ior(boundary.ior));
    lobe.film_thickness_nm = boundary.film_thickness_nm;
    lobe.film_ior = boundary.film_ior;
    lobe.film_space = boundary.film_space;
}

// As add_dielectric, in one colour.
[[nodiscard]] float add_plain_dielectric(Bsdf& bsdf,
                                         Lobe& lobe,
                                         const GgxSurface& surface,
                                         float roughness)
{
    const float f0 = f0_from_ior(lobe.ior);
    float albedo = mix(f0, 1.0f, dielectric_albedo_blend(roughness, surface.cos_o, lobe.ior));
    const Color3f weight = lobe.weight;
    if (is_compensated(lobe, surface)) {
        const LobeEnergy energy = reflection_energy(roughness, surface.cos_o);
        const float factor =
            energy_compensation(energy, std::max(f0, mean_fresnel_dielectric(lobe.ior)));
        lobe.weight *= factor;
        albedo *= factor * energy.albedo;
    }
    bsdf.add(lobe, weight * albedo);
    return albedo;
}

// The albedo of a tinted one without its weight and compensation.
[[nodiscard]] Color3f tinted_albedo(const Lobe& lobe, const GgxSurface& surface, float blend)
{
    if (lobe.film_thickness_nm > 0.0f) {
        Lobe unit = lobe;
        unit.weight = Color3f(1.0f);
        return facet_albedo(unit, surface.cos_o).reflected;
    }
    return blend_to_white(lobe.f0, blend);
}

}  // namespace

float add_dielectric(Bsdf& bsdf,
                     const GgxSurface& surface,
                     const Color3f& weight,
                     const Boundary& boundary)
{
    Lobe lobe = surface_lobe(LobeKind::Dielectric, weight, surface);
    lobe.ior = boundary.ior;
    const float roughness = table_roughness(lobe, surface);
    if (is_plain(boundary)) {
        return add_plain_dielectric(bsdf, lobe, surface, roughness);
    }
    tint(lobe, boundary, LobeKind::TintedDielectric);
    const float mean_blend =
        dielectric_blend(mean_fresnel_dielectric(lobe.ior), f0_from_ior(lobe.ior));
    const Compensation c = compensate(lobe, surface, blend_to_white(lobe.f0, mean_blend));
    const float blend = dielectric_albedo_blend(roughness, surface.cos_o, lobe.ior);
    const Color3f albedo = tinted_albedo(lobe, surface, blend) * c.albedo;
    lobe.weight *= c.factor;
    bsdf.add(lobe, albedo * weight);
    return max_component(albedo);
}

float add_coat(Bsdf& bsdf, const GgxSurface& surface, const Color3f& weight, float ior)
{
    Lobe lobe = surface_lobe(LobeKind::Dielectric, weight, surface);
    lobe.ior = ior;
    const float albedo =
        fresnel_dielectric(std::clamp(surface.cos_o, 0.0f, 1.0f), ior).reflectance;
    bsdf.add(lobe, weight * albedo);
    return albedo;
}

void add_glass(Bsdf& bsdf,
               const GgxSurface& surface,
               const Color3f& weight,
               const Color3f& reflection,
               const Color3f& transmission,
               const Boundary& boundary)
{
    Lobe lobe = surface_lobe(LobeKind::Glass, weight * reflection, surface);
    lobe.second_weight = weight * transmission;
    lobe.ior = boundary.ior;
    if (!is_plain(boundary)) {
        tint(lobe, boundary, LobeKind::TintedGlass);
    }
    // As of smooth glass.
    FacetAlbedo albedo = facet_albedo(lobe, surface.cos_o);
    if (is_compensated(lobe, surface)) {
        // Most light passes, so its colour stands for that of the bounces in between.
        const Compensation c =
            compensate(glass_energy(surface.roughness, surface.cos_o, boundary.ior),
                       unit_range(transmission));
        lobe.weight *= c.factor;
        lobe.second_weight *= c.factor;
        albedo.reflected *= c.albedo;
        albedo.transmitted *= c.albedo;
    }
    bsdf.add(lobe, albedo.reflected + albedo.transmitted, albedo.transmitted);
}

void add_refraction(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color, float ior)
{
    Lobe lobe = surface_lobe(LobeKind::Refraction, Color3f(0.0f), surface);
    lobe.second_weight = color;
    lobe.ior = ior;
    bsdf.add(lobe, color);
}

}  // namespace eye_render
