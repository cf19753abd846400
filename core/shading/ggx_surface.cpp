// Weights and albedos of the lobes.

#include "shading/ggx_surface.h"

#include "shading/energy_tables.h"
#include "shading/frame.h"
#include "shading/fresnel.h"
#include "shading/input_range.h"
#include "shading/lookup_table.h"
#include "shading/microfacet_lobe.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

[[nodiscard]] Lobe surface_lobe(LobeKind kind, const Color3f& weight, const GgxSurface& surface)
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
[[nodiscard]] float table_roughness(const Lobe& lobe, const GgxSurface& surface)
{
    return lobe.alpha_x == lobe.alpha_y ? surface.roughness
                                        : std::sqrt(std::sqrt(lobe.alpha_x * lobe.alpha_y));
}

struct Compensation {
    Color3f factor{1.0f};
    Color3f albedo{1.0f};  // of the lobe without its Fresnel
};

[[nodiscard]] Compensation compensate(const LobeEnergy& energy, const Color3f& mean_fresnel)
{
    const Color3f factor = energy_compensation(energy, mean_fresnel);
    return {factor, factor * energy.albedo};
}

[[nodiscard]] bool is_compensated(const Lobe& lobe, const GgxSurface& surface)
{
    // A mirror loses nothing.
    return surface.multiple_scattering && surface.facets == FacetModel::Ggx && !lobe.is_delta();
}

// For a reflecting lobe.
[[nodiscard]] Compensation compensate(const Lobe& lobe,
                                      const GgxSurface& surface,
                                      const Color3f& mean_fresnel)
{
    return is_compensated(lobe, surface)
               ? compensate(reflection_energy(table_roughness(lobe, surface), surface.cos_o),
                            mean_fresnel)
               : Compensation{};
}

// Of a metal or a mirror, whose Fresnel has this albedo.
void add_reflection(Bsdf& bsdf,
                    Lobe& lobe,
                    const GgxSurface& surface,
                    const Color3f& mean_fresnel,
                    const Color3f& albedo)
{
    const Compensation c = compensate(lobe, surface, mean_fresnel);
    lobe.weight *= c.factor;
    bsdf.add(lobe, albedo * c.albedo);
}

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
        return facet_albedo(unit, surface.cos_o);
    }
    return blend_to_white(lobe.f0, blend);
}

}  // namespace

void brush(GgxSurface& surface,
           float stretch_x,
           float stretch_y,
           const V3f& tangent,
           float rotation_turns,
           const V3f& axis)
{
    surface.stretch_x = stretch_x;
    surface.stretch_y = stretch_y;
    const float angle = 2.0f * std::numbers::pi_v<float> * rotation_turns;
    const float cosine = std::cos(angle);
    const V3f turned = tangent * cosine + axis.cross(tangent) * std::sin(angle) +
                       axis * (axis.dot(tangent) * (1.0f - cosine));
    const V3f across = surface.normal.cross(turned);
    const float length = across.length();
    surface.tangent =
        length > 0.0f ? across.cross(surface.normal) / length : Frame(surface.normal).s;
}

void add_glossy(Bsdf& bsdf, const GgxSurface& surface, float weight, const Color3f& color)
{
    Lobe lobe = surface_lobe(LobeKind::Glossy, color * weight, surface);
    add_reflection(bsdf, lobe, surface, unit_range(color), color * weight);
}

void add_phong(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color)
{
    Lobe lobe = surface_lobe(LobeKind::AshikhminShirley, color, surface);
    bsdf.add(lobe, color);
}

void add_metal(Bsdf& bsdf,
               const GgxSurface& surface,
               const Color3f& weight,
               const Color3f& f0,
               const Color3f& edge_tint)
{
    Lobe lobe = surface_lobe(LobeKind::Metal, weight, surface);
    lobe.f0 = f0;
    if (edge_tint != Color3f(1.0f)) {
        lobe.edge = f82_edge(f0, edge_tint);
    }
    const float blend = schlick_albedo_blend(table_roughness(lobe, surface), surface.cos_o);
    add_reflection(bsdf, lobe, surface, mean_f82_fresnel(f0, lobe.edge),
                   weight * blend_to_white(f0, blend));
}

void add_conductor(Bsdf& bsdf,
                   const GgxSurface& surface,
                   float weight,
                   const Color3f& index,
                   const Color3f& extinction)
{
    Lobe lobe = surface_lobe(LobeKind::Conductor, Color3f(weight), surface);
    lobe.f0 = index;
    lobe.edge = extinction;
    // The mean Fresnel of the fit that meets it at normal incidence and near 82 degrees.
    const Color3f f0 = fresnel_conductor(1.0f, index, extinction);
    const Color3f f82 = fresnel_conductor(1.0f / 7.0f, index, extinction);
    const Color3f edge = f82_edge(f0, f82 / blend_to_white(f0, schlick_blend(1.0f / 7.0f)));
    add_reflection(bsdf, lobe, surface, unit_range(mean_f82_fresnel(f0, edge)),
                   facet_albedo(lobe, surface.cos_o));
}

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
    Color3f albedo = facet_albedo(lobe, surface.cos_o);
    if (is_compensated(lobe, surface)) {
        // Most light passes, so its colour stands for that of the bounces in between.
        const Compensation c =
            compensate(glass_energy(surface.roughness, surface.cos_o, boundary.ior),
                       unit_range(transmission));
        lobe.weight *= c.factor;
        lobe.second_weight *= c.factor;
        albedo *= c.albedo;
    }
    bsdf.add(lobe, albedo);
}

void add_refraction(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color, float ior)
{
    Lobe lobe = surface_lobe(LobeKind::Refraction, Color3f(0.0f), surface);
    lobe.second_weight = color;
    lobe.ior = ior;
    bsdf.add(lobe, color);
}

}  // namespace eye_render
