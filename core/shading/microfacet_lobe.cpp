// Evaluation and sampling of lobes of microfacets.

#include "shading/microfacet_lobe.h"

#include "shading/frame.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"
#include "shading/thin_film.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

struct Split {
    Color3f reflected;
    Color3f transmitted{0.0f};
    float cos_transmitted = 0.0f;

    // Of choosing reflection.
    [[nodiscard]] float probability() const
    {
        const float r = reflected.x + reflected.y + reflected.z;
        const float t = transmitted.x + transmitted.y + transmitted.z;
        return t > 0.0f ? r / (r + t) : 1.0f;
    }
};

[[nodiscard]] Color3f tinted_reflectance(const Lobe& lobe, float cos_facet, float untinted)
{
    if (lobe.film_thickness_nm > 0.0f) {
        return tinted_film_reflectance(cos_facet, lobe.film_thickness_nm, lobe.film_ior, lobe.ior,
                                       lobe.f0, lobe.film_space);
    }
    return blend_to_white(lobe.f0, dielectric_blend(untinted, f0_from_ior(lobe.ior)));
}

[[nodiscard]] Split split_at_rare_facet(const Lobe& lobe, float cos_facet)
{
    if (lobe.kind == LobeKind::Conductor) {
        return {lobe.weight * fresnel_conductor(cos_facet, lobe.f0, lobe.edge)};
    }
    const DielectricFresnel f = fresnel_dielectric(cos_facet, lobe.ior);
    if (lobe.kind == LobeKind::Refraction) {
        return {Color3f(0.0f), f.cos_transmitted > 0.0f ? lobe.second_weight : Color3f(0.0f),
                f.cos_transmitted};
    }
    const Color3f reflected = tinted_reflectance(lobe, cos_facet, f.reflectance);
    if (lobe.kind == LobeKind::TintedDielectric) {
        return {lobe.weight * reflected};
    }
    if (f.cos_transmitted == 0.0f) {
        return {lobe.weight};
    }
    return {lobe.weight * reflected, lobe.second_weight * (Color3f(1.0f) - reflected),
            f.cos_transmitted};
}

// What one facet does to light that leaves it under `cos_facet`, the lobe's weights included. What
// most materials have stands here, to be inlined.
[[nodiscard]] inline Split split_at_facet(const Lobe& lobe, float cos_facet)
{
    switch (lobe.kind) {
    case LobeKind::Glossy: return {lobe.weight};
    case LobeKind::Metal: return {lobe.weight * f82_fresnel(cos_facet, lobe.f0, lobe.edge)};
    case LobeKind::Dielectric:
        return {lobe.weight * fresnel_dielectric(cos_facet, lobe.ior).reflectance};
    case LobeKind::Glass: {
        const DielectricFresnel f = fresnel_dielectric(cos_facet, lobe.ior);
        return {lobe.weight * f.reflectance, lobe.second_weight * (1.0f - f.reflectance),
                f.cos_transmitted};
    }
    default: return split_at_rare_facet(lobe, cos_facet);
    }
}

[[nodiscard]] bool is_isotropic(const Lobe& lobe) { return lobe.alpha_x == lobe.alpha_y; }

[[nodiscard]] Frame facet_frame(const Lobe& lobe)
{
    return is_isotropic(lobe) ? Frame(lobe.normal) : Frame(lobe.normal, lobe.tangent);
}

struct FacetTerms {
    float density;  // of facets that point to m
    float smith_o;
    float smith_i;
};

[[nodiscard]] FacetTerms facet_terms(const Lobe& lobe,
                                     const V3f& m,
                                     const V3f& wo,
                                     const V3f& wi,
                                     float cos_o,
                                     float cos_i)
{
    const float ax = lobe.alpha_x;
    const float ay = lobe.alpha_y;
    if (lobe.facets == FacetModel::Ggx && ax == ay) {
        const float alpha2 = ax * ax;
        const float cos_m = lobe.normal.dot(m);
        return {ggx_density(alpha2, cos_m * cos_m, lobe.normal.cross(m).length2()),
                smith_term(alpha2, cos_o), smith_term(alpha2, cos_i)};
    }
    const Frame frame = facet_frame(lobe);
    const V3f m_local = frame.local_from_world(m);
    const V3f o_local = frame.local_from_world(wo);
    V3f i_local = frame.local_from_world(wi);
    i_local.z = cos_i;
    if (lobe.facets == FacetModel::Ggx) {
        return {ggx_density(ax, ay, m_local), smith_term(ax, ay, o_local),
                smith_term(ax, ay, i_local)};
    }
    return {beckmann_density(ax, ay, m_local), beckmann_smith_term(ax, ay, o_local),
            beckmann_smith_term(ax, ay, i_local)};
}

}  // namespace

FacetAlbedo facet_albedo(const Lobe& lobe, float cos_facet)
{
    const Split split = split_at_facet(lobe, std::clamp(cos_facet, 0.0f, 1.0f));
    return {.reflected = split.reflected, .transmitted = split.transmitted};
}

BsdfValue evaluate_microfacet(const Lobe& lobe, const V3f& wo, const V3f& wi, bool transmitted)
{
    const float cos_o = lobe.normal.dot(wo);
    const float cos_i = lobe.normal.dot(wi) * (transmitted ? -1.0f : 1.0f);
    if (!(cos_o > 0.0f && cos_i > 0.0f)) {
        return {};
    }

    // The facet that turns wi into wo; it points to the side of the lobe's normal.
    V3f m = transmitted ? wo + wi * lobe.ior : wo + wi;
    const float length = m.length();
    m *= (m.dot(lobe.normal) < 0.0f ? -1.0f : 1.0f) / length;
    const float facet_o = wo.dot(m);
    const float facet_i = wi.dot(m) * (transmitted ? -1.0f : 1.0f);
    if (!(facet_o > 0.0f && facet_i > 0.0f)) {
        return {};
    }

    const FacetTerms terms = facet_terms(lobe, m, wo, wi, cos_o, cos_i);
    // Solid angle of facets for that of wi, times the cosine under which wo sees the facets.
    const float jacobian =
        transmitted ? facet_o * facet_i * lobe.ior * lobe.ior / (length * length) : 0.25f;

    const Split split = split_at_facet(lobe, std::min(1.0f, facet_o));
    const float probability = split.probability();
    const Color3f& color = transmitted ? split.transmitted : split.reflected;
    const float common = terms.density * jacobian;
    return {color *
                (common * masking_shadowing_over_cos(cos_o, terms.smith_o, cos_i, terms.smith_i)),
            common * masking_over_cos(cos_o, terms.smith_o) *
                (transmitted ? 1.0f - probability : probability)};
}

std::optional<LobeSample> sample_microfacet(const Lobe& lobe,
                                            const V3f& wo,
                                            float u_choice,
                                            const V2f& u)
{
    V3f m = lobe.normal;
    if (!lobe.is_delta()) {
        const Frame frame = facet_frame(lobe);
        const V3f wo_local = frame.local_from_world(wo);
        m = frame.world_from_local(
            lobe.facets == FacetModel::Ggx
                ? sample_visible_normal(wo_local, lobe.alpha_x, lobe.alpha_y, u)
                : sample_visible_beckmann_normal(wo_local, lobe.alpha_x, lobe.alpha_y, u));
    }
    const float cos_facet = std::min(1.0f, wo.dot(m));
    if (!(cos_facet > 0.0f)) {
        return std::nullopt;
    }
    const Split split = split_at_facet(lobe, cos_facet);
    const float probability = split.probability();
    if (u_choice < probability) {
        if (!lobe.reflects()) {
            return std::nullopt;  // totally reflected inside
        }
        return LobeSample{m * (2.0f * cos_facet) - wo, false, split.reflected / probability};
    }
    const V3f wi = m * (cos_facet / lobe.ior - split.cos_transmitted) - wo / lobe.ior;
    return LobeSample{wi.normalized(), true, split.transmitted / (1.0f - probability)};
}

}  // namespace eye_render
