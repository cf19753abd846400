// Weights and albedos of mirrors and metals, and brushing.

#include "shading/ggx_surface.h"

#include "shading/energy_tables.h"
#include "shading/frame.h"
#include "shading/fresnel.h"
#include "shading/input_range.h"
#include "shading/microfacet_lobe.h"
#include "shading/surface_lobe.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

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
    // As in Cycles; the exponents are 2 over its square.
    constexpr float smallest_alpha = 1e-4f;
    Lobe lobe = surface_lobe(LobeKind::AshikhminShirley, color, surface);
    lobe.alpha_x = std::max(lobe.alpha_x, smallest_alpha);
    lobe.alpha_y = std::max(lobe.alpha_y, smallest_alpha);
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
                   facet_albedo(lobe, surface.cos_o).reflected);
}

}  // namespace eye_render
