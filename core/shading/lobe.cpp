// Lobes are made here, and handed to the file of their kind.

#include "shading/lobe.h"

#include "shading/diffuse_lobe.h"
#include "shading/fibre_lobe.h"
#include "shading/glossy_lobe.h"
#include "shading/microfacet_lobe.h"

namespace eye_render {

Lobe straight_lobe(const Color3f& weight)
{
    return plain_lobe(LobeKind::Straight, weight, V3f(0.0f));
}

Lobe glossy_lobe(const Color3f& weight, const V3f& normal, float alpha)
{
    return plain_lobe(LobeKind::Glossy, weight, normal, alpha);
}

Lobe metal_lobe(const Color3f& weight, const V3f& normal, float alpha, const Color3f& f0)
{
    Lobe lobe = plain_lobe(LobeKind::Metal, weight, normal, alpha);
    lobe.f0 = f0;
    return lobe;
}

Lobe dielectric_lobe(const Color3f& weight, const V3f& normal, float alpha, float ior)
{
    Lobe lobe = plain_lobe(LobeKind::Dielectric, weight, normal, alpha);
    lobe.ior = ior;
    return lobe;
}

Lobe glass_lobe(const Color3f& reflection,
                const Color3f& transmission,
                const V3f& normal,
                float alpha,
                float ior)
{
    Lobe lobe = plain_lobe(LobeKind::Glass, reflection, normal, alpha);
    lobe.ior = ior;
    lobe.second_weight = transmission;
    return lobe;
}

Lobe refraction_lobe(const Color3f& transmission, const V3f& normal, float alpha, float ior)
{
    Lobe lobe = plain_lobe(LobeKind::Refraction, Color3f(0.0f), normal, alpha);
    lobe.ior = ior;
    lobe.second_weight = transmission;
    return lobe;
}

BsdfValue evaluate(const Lobe& lobe, const V3f& wo, const V3f& wi, bool transmitted)
{
    if (!(transmitted ? lobe.transmits() : lobe.reflects())) {
        return {};
    }
    if (lobe.is_diffuse()) {
        return evaluate_diffuse(lobe, wo, wi);
    }
    switch (lobe.kind) {
    case LobeKind::GlossyToon: return evaluate_glossy_toon(lobe, wo, wi);
    case LobeKind::Velvet: return evaluate_velvet(lobe, wo, wi);
    case LobeKind::Fibre: return evaluate_fibre(lobe, wo, wi);
    case LobeKind::AshikhminShirley: return evaluate_ashikhmin_shirley(lobe, wo, wi);
    default: return evaluate_microfacet(lobe, wo, wi, transmitted);
    }
}

std::optional<LobeSample> sample(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u)
{
    if (lobe.is_diffuse()) {
        return LobeSample{sample_diffuse(lobe, wo, u), lobe.kind == LobeKind::Translucent};
    }
    switch (lobe.kind) {
    case LobeKind::Straight: return LobeSample{-wo, true, lobe.weight};
    case LobeKind::GlossyToon: return LobeSample{sample_glossy_toon(lobe, wo, u)};
    case LobeKind::Velvet: return LobeSample{sample_velvet(lobe, u)};
    case LobeKind::Fibre: {
        const V3f wi = sample_fibre(lobe, wo, u_choice, u);
        return LobeSample{wi, lobe.normal.dot(wi) < 0.0f};
    }
    case LobeKind::AshikhminShirley: {
        const std::optional<V3f> wi = sample_ashikhmin_shirley(lobe, wo, u);
        return wi ? std::optional(LobeSample{*wi, false, lobe.weight}) : std::nullopt;
    }
    default: return sample_microfacet(lobe, wo, u_choice, u);
    }
}

}  // namespace eye_render
