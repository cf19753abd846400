// One lobe of a BSDF mixture. World space, unit directions away from the surface; radiance flows
// from wi to wo, and wo is on the side of the lobe's normal unless the lobe is diffuse.

#pragma once

#include "base/working_space.h"
#include "shading/microfacet.h"

#include <cmath>
#include <cstdint>
#include <optional>

namespace eye_render {

struct BsdfValue {
    Color3f value{0.0f};  // f(wo, wi) |cos(ns, wi)|, delta lobes left out
    float pdf = 0.0f;     // of `sample` choosing wi, delta lobes left out
};

enum class LobeKind : std::uint8_t {
    Straight,  // passes light as if there were no surface
    // Let light in that leaves elsewhere (subsurface.h): nothing to evaluate, and not sampled
    // here.
    RandomWalk,        // through a medium, from a refracting boundary
    RandomWalkLegacy,  // the same through the medium of older Blenders
    RandomWalkSkin,    // that from a boundary half Lambert, half refracting
    Burley,            // by Christensen and Burley's profile
    // Wide lobes (diffuse_lobe.h).
    Diffuse,      // Lambert
    OrenNayar,    // rough Lambert
    Translucent,  // Lambert on the far side
    Sheen,        // linearly transformed cosine
    DiffuseToon,  // cone around the normal
    // Glossy ones.
    GlossyToon,        // cone around the mirror direction
    Velvet,            // Ashikhmin's
    Fibre,             // of hair, from all around it (fibre_lobe.h)
    AshikhminShirley,  // Phong-like
    // Microfacets (microfacet_lobe.h).
    Glossy,            // reflection without Fresnel
    Metal,             // reflection, Schlick's Fresnel from `f0` to white, less `edge`
    Conductor,         // reflection, Fresnel of index `f0` and extinction `edge`
    Dielectric,        // reflection, dielectric Fresnel
    TintedDielectric,  // the same from `f0` to white, or under a thin film
    Glass,             // reflection and transmission, dielectric Fresnel
    TintedGlass,       // the same from `f0` to white, or under a thin film
    Refraction,        // transmission without Fresnel
};

enum class FacetModel : std::uint8_t { Ggx, Beckmann };

// Made by the functions below only. Without initialisers because a mixture holds room for several
// per hit, and clearing it would cost a tenth of shading.
struct Lobe {
    LobeKind kind;
    FacetModel facets;        // microfacets
    WorkingSpace film_space;  // tinted dielectrics: what colours under a film are in
    Color3f weight;
    V3f normal;
    V3f smooth_normal;  // Diffuse to DiffuseToon: the normal before any map
    // Where alpha_x is not alpha_y: unit, across the normal. Fibre: along it, unit.
    V3f tangent;
    float alpha_x;  // microfacets: along the tangent; below smallest_rough_alpha a delta
    float alpha_y;  // and across it
    float ior;      // dielectrics, fibres, subsurface: of the far side over the near side
    // Metal, tinted dielectrics: colour at normal incidence. Conductor: index.
    // Fibre: what it absorbs along its radius. Subsurface: the colour that comes out.
    Color3f f0;
    // Metal: factor of cos (1 - cos)^6. Conductor: extinction. Fibre: variances along it of what
    // it reflects, transmits, and reflects inside. Subsurface: radius.
    Color3f edge;
    // Glasses, Refraction: weight of what passes; `weight` is of what is reflected.
    // OrenNayar: weight of what is scattered more than once.
    Color3f second_weight;
    float film_thickness_nm;  // tinted dielectrics; 0 for none
    float film_ior;           // over the near side's
    // OrenNayar: constant and slope of the model. Sheen: the transform's. Toons: half angle of the
    // cone and the width of its soft edge, rad. Velvet: a is 1 / sigma^2. Fibre: scale of the
    // logistic distribution around it and tilt of its scales, rad. Subsurface: a is the
    // anisotropy.
    float a;
    float b;

    // True of lobes that have no value in a direction.
    [[nodiscard]] bool is_delta() const
    {
        return kind >= LobeKind::AshikhminShirley ? is_delta_of_facets()
                                                  : kind <= LobeKind::Burley;
    }
    [[nodiscard]] bool is_subsurface() const
    {
        return kind >= LobeKind::RandomWalk && kind <= LobeKind::Burley;
    }
    // What is not is glossy or straight.
    [[nodiscard]] bool is_diffuse() const
    {
        return kind >= LobeKind::Diffuse && kind <= LobeKind::DiffuseToon;
    }
    // What it scatters is in the diffuse passes.
    [[nodiscard]] bool counts_as_diffuse() const
    {
        return kind >= LobeKind::RandomWalk && kind <= LobeKind::DiffuseToon;
    }
    [[nodiscard]] bool has_facets() const { return kind >= LobeKind::AshikhminShirley; }
    // Light may come from the far side.
    [[nodiscard]] bool transmits() const
    {
        return kind == LobeKind::Straight || kind == LobeKind::Translucent ||
               kind == LobeKind::Fibre || kind >= LobeKind::Glass;
    }
    // Light may come from the near side.
    [[nodiscard]] bool reflects() const
    {
        return kind != LobeKind::Straight && kind != LobeKind::Translucent &&
               kind != LobeKind::Refraction;
    }

private:
    [[nodiscard]] bool is_delta_of_facets() const
    {
        // Between indices this close, light is bent by less than any lobe is wide, and the half
        // vector cannot be had from two nearly opposite directions: the glass becomes a delta.
        constexpr float matched_ior = 1e-3f;
        const bool is_smooth = alpha_x * alpha_y < smallest_rough_alpha * smallest_rough_alpha;
        return is_smooth || (transmits() && std::abs(ior - 1.0f) < matched_ior);
    }
};

// Without any of the fields above that its kind does not share with all; `alpha` as of a glossy
// lobe. Inline, as all on its way into a mixture is: a lobe of 120 bytes is then put together
// where it stays. Copied there, a plain Principled would take 230 instructions more than its 1,160
// a shade.
[[nodiscard]] inline Lobe plain_lobe(LobeKind kind,
                                     const Color3f& weight,
                                     const V3f& normal,
                                     float alpha = 1.0f)
{
    return {.kind = kind,
            .facets = FacetModel::Ggx,
            .film_space = WorkingSpace::Rec709,
            .weight = weight,
            .normal = normal,
            .smooth_normal = normal,
            .tangent = V3f(0.0f),
            .alpha_x = alpha,
            .alpha_y = alpha,
            .ior = 1.0f,
            .f0 = Color3f(0.0f),
            .edge = Color3f(0.0f),
            .second_weight = Color3f(0.0f),
            .film_thickness_nm = 0.0f,
            .film_ior = 1.0f,
            .a = 0.0f,
            .b = 0.0f};
}

[[nodiscard]] inline Lobe diffuse_lobe(const Color3f& weight,
                                       const V3f& normal,
                                       const V3f& smooth_normal)
{
    Lobe lobe = plain_lobe(LobeKind::Diffuse, weight, normal);
    lobe.smooth_normal = smooth_normal;
    return lobe;
}

[[nodiscard]] Lobe straight_lobe(const Color3f& weight);
[[nodiscard]] Lobe glossy_lobe(const Color3f& weight, const V3f& normal, float alpha);
[[nodiscard]] Lobe metal_lobe(const Color3f& weight,
                              const V3f& normal,
                              float alpha,
                              const Color3f& f0);
[[nodiscard]] Lobe dielectric_lobe(const Color3f& weight,
                                   const V3f& normal,
                                   float alpha,
                                   float ior);
[[nodiscard]] Lobe glass_lobe(const Color3f& reflection,
                              const Color3f& transmission,
                              const V3f& normal,
                              float alpha,
                              float ior);
[[nodiscard]] Lobe refraction_lobe(const Color3f& transmission,
                                   const V3f& normal,
                                   float alpha,
                                   float ior);
// `transmitted` says that wi is on the far side of the geometry; where the lobe's normal
// disagrees the value is zero. Not for delta lobes.
[[nodiscard]] BsdfValue evaluate(const Lobe& lobe, const V3f& wo, const V3f& wi, bool transmitted);

struct LobeSample {
    V3f wi;
    bool is_transmitted = false;
    Color3f delta_weight{0.0f};  // of a delta lobe: value over probability
};

// Nothing if no light comes from what was drawn. `u_choice` decides between reflection and
// transmission. Not for subsurface lobes.
[[nodiscard]] std::optional<LobeSample> sample(const Lobe& lobe,
                                               const V3f& wo,
                                               float u_choice,
                                               const V2f& u);

}  // namespace eye_render
