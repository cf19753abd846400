// Evaluation and sampling of single lobes. The GGX lobes are Walter et al. 2007, "Microfacet
// Models for Refraction through Rough Surfaces", eq. 20 and 21, sampled by visible normals.
// Transmission is not scaled by the square of the index: radiance is traced as if it were basic
// radiance, as Cycles does, so that a window looks as bright as the hole it fills.

#include "shading/lobe.h"

#include "base/warp.h"
#include "shading/frame.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// Between indices this close, light is bent by less than any lobe is wide, and the half vector
// cannot be had from two nearly opposite directions: the glass becomes a delta.
constexpr float matched_ior = 1e-3f;

[[nodiscard]] Lobe make_lobe(LobeKind kind, const Color3f& weight, const V3f& normal, float alpha)
{
    return {.kind = kind,
            .weight = weight,
            .normal = normal,
            .smooth_normal = normal,
            .alpha = alpha,
            .ior = 1.0f,
            .f0 = Color3f(0.0f),
            .transmission = Color3f(0.0f)};
}

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

// What one facet does to light that leaves it under `cos_facet`, the lobe's weight included.
[[nodiscard]] Split split_at_facet(const Lobe& lobe, float cos_facet)
{
    switch (lobe.kind) {
    case LobeKind::Metal: return {lobe.weight * blend_to_white(lobe.f0, schlick_blend(cos_facet))};
    case LobeKind::Dielectric:
        return {lobe.weight * fresnel_dielectric(cos_facet, lobe.ior).reflectance};
    case LobeKind::Glass: {
        const DielectricFresnel f = fresnel_dielectric(cos_facet, lobe.ior);
        return {lobe.weight * f.reflectance, lobe.transmission * (1.0f - f.reflectance),
                f.cos_transmitted};
    }
    default: return {lobe.weight};
    }
}

// Softens the edge between light and shadow where a normal map turns the normal far from the
// smooth one: Chiang et al. 2019, "Taming the Shadow Terminator".
[[nodiscard]] float terminator_softening(const Lobe& lobe, const V3f& wi, float cos_i)
{
    const float cos_smooth = lobe.smooth_normal.dot(wi);
    const float g = cos_smooth / (cos_i * lobe.smooth_normal.dot(lobe.normal));
    if (g >= 1.0f) {
        return 1.0f;
    }
    return g > 0.0f ? g * (1.0f + g * (1.0f - g)) : 0.0f;
}

[[nodiscard]] BsdfValue evaluate_diffuse(const Lobe& lobe, const V3f& wi)
{
    const float cos_i = lobe.normal.dot(wi);
    if (!(cos_i > 0.0f)) {
        return {};
    }
    const float pdf = cosine_hemisphere_pdf(cos_i);
    if (lobe.normal == lobe.smooth_normal) {
        return {lobe.weight * pdf, pdf};
    }
    return {lobe.weight * (pdf * terminator_softening(lobe, wi, cos_i)), pdf};
}

[[nodiscard]] BsdfValue evaluate_microfacet(const Lobe& lobe,
                                            const V3f& wo,
                                            const V3f& wi,
                                            bool transmitted)
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

    const float alpha2 = lobe.alpha * lobe.alpha;
    const float cos_m = lobe.normal.dot(m);
    const float density = ggx_density(alpha2, cos_m * cos_m, lobe.normal.cross(m).length2());
    // Solid angle of facets for that of wi, times the cosine under which wo sees the facets.
    const float jacobian =
        transmitted ? facet_o * facet_i * lobe.ior * lobe.ior / (length * length) : 0.25f;
    const float smith_o = smith_term(alpha2, cos_o);
    const float smith_i = smith_term(alpha2, cos_i);

    const Split split = split_at_facet(lobe, std::min(1.0f, facet_o));
    const float probability = split.probability();
    const Color3f& color = transmitted ? split.transmitted : split.reflected;
    const float common = density * jacobian;
    return {color * (common * masking_shadowing_over_cos(cos_o, smith_o, cos_i, smith_i)),
            common * masking_over_cos(cos_o, smith_o) *
                (transmitted ? 1.0f - probability : probability)};
}

[[nodiscard]] std::optional<LobeSample> sample_microfacet(const Lobe& lobe,
                                                          const V3f& wo,
                                                          float u_choice,
                                                          const V2f& u)
{
    V3f m = lobe.normal;
    if (!lobe.is_delta()) {
        const Frame frame(lobe.normal);
        m = frame.world_from_local(
            sample_visible_normal(frame.local_from_world(wo), lobe.alpha, u));
    }
    const float cos_facet = std::min(1.0f, wo.dot(m));
    if (!(cos_facet > 0.0f)) {
        return std::nullopt;
    }
    const Split split = split_at_facet(lobe, cos_facet);
    const float probability = split.probability();
    if (u_choice < probability) {
        return LobeSample{m * (2.0f * cos_facet) - wo, false, split.reflected / probability};
    }
    const V3f wi = m * (cos_facet / lobe.ior - split.cos_transmitted) - wo / lobe.ior;
    return LobeSample{wi.normalized(), true, split.transmitted / (1.0f - probability)};
}

}  // namespace

bool Lobe::is_delta() const
{
    switch (kind) {
    case LobeKind::Straight: return true;
    case LobeKind::Diffuse: return false;
    case LobeKind::Glass:
        return alpha < smallest_rough_alpha || std::abs(ior - 1.0f) < matched_ior;
    default: return alpha < smallest_rough_alpha;
    }
}

Lobe straight_lobe(const Color3f& weight)
{
    return make_lobe(LobeKind::Straight, weight, V3f(0.0f), 0.0f);
}

Lobe diffuse_lobe(const Color3f& weight, const V3f& normal, const V3f& smooth_normal)
{
    Lobe lobe = make_lobe(LobeKind::Diffuse, weight, normal, 0.0f);
    lobe.smooth_normal = smooth_normal;
    return lobe;
}

Lobe glossy_lobe(const Color3f& weight, const V3f& normal, float alpha)
{
    return make_lobe(LobeKind::Glossy, weight, normal, alpha);
}

Lobe metal_lobe(const Color3f& weight, const V3f& normal, float alpha, const Color3f& f0)
{
    Lobe lobe = make_lobe(LobeKind::Metal, weight, normal, alpha);
    lobe.f0 = f0;
    return lobe;
}

Lobe dielectric_lobe(const Color3f& weight, const V3f& normal, float alpha, float ior)
{
    Lobe lobe = make_lobe(LobeKind::Dielectric, weight, normal, alpha);
    lobe.ior = ior;
    return lobe;
}

Lobe glass_lobe(const Color3f& reflection,
                const Color3f& transmission,
                const V3f& normal,
                float alpha,
                float ior)
{
    Lobe lobe = make_lobe(LobeKind::Glass, reflection, normal, alpha);
    lobe.ior = ior;
    lobe.transmission = transmission;
    return lobe;
}

BsdfValue evaluate(const Lobe& lobe, const V3f& wo, const V3f& wi, bool transmitted)
{
    if (transmitted && lobe.kind != LobeKind::Glass) {
        return {};
    }
    return lobe.kind == LobeKind::Diffuse ? evaluate_diffuse(lobe, wi)
                                          : evaluate_microfacet(lobe, wo, wi, transmitted);
}

std::optional<LobeSample> sample(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u)
{
    switch (lobe.kind) {
    case LobeKind::Straight: return LobeSample{-wo, true, lobe.weight};
    case LobeKind::Diffuse:
        return LobeSample{Frame(lobe.normal).world_from_local(sample_cosine_hemisphere(u))};
    default: return sample_microfacet(lobe, wo, u_choice, u);
    }
}

}  // namespace eye_render
