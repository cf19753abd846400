// Weights and albedos of the GGX lobes.

#include "shading/ggx_surface.h"

#include "shading/energy_tables.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"

#include <algorithm>

namespace eye_render {

namespace {

[[nodiscard]] float alpha_of(const GgxSurface& surface)
{
    return surface.roughness * surface.roughness;
}

// A mirror loses nothing.
[[nodiscard]] bool is_compensated(const GgxSurface& surface)
{
    return surface.multiple_scattering && alpha_of(surface) >= smallest_rough_alpha;
}

// Colours above white are not physical, and the series of bounces would not converge.
[[nodiscard]] Color3f at_most_white(const Color3f& color)
{
    return {std::min(color.x, 1.0f), std::min(color.y, 1.0f), std::min(color.z, 1.0f)};
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

[[nodiscard]] Compensation compensate_reflection(const GgxSurface& surface,
                                                 const Color3f& mean_fresnel)
{
    return is_compensated(surface)
               ? compensate(reflection_energy(surface.roughness, surface.cos_o), mean_fresnel)
               : Compensation{};
}

}  // namespace

void add_glossy(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color)
{
    const Compensation c = compensate_reflection(surface, at_most_white(color));
    bsdf.add(glossy_lobe(color * c.factor, surface.normal, alpha_of(surface)), color * c.albedo);
}

void add_metal(Bsdf& bsdf, const GgxSurface& surface, float weight, const Color3f& f0)
{
    const Compensation c = compensate_reflection(surface, blend_to_white(f0, mean_schlick_blend));
    const float blend = schlick_albedo_blend(surface.roughness, surface.cos_o);
    bsdf.add(metal_lobe(c.factor * weight, surface.normal, alpha_of(surface), f0),
             c.albedo * blend_to_white(f0, blend) * weight);
}

float add_dielectric(Bsdf& bsdf, const GgxSurface& surface, float weight, float ior)
{
    const float f0 = f0_from_ior(ior);
    const float mean_fresnel = std::max(f0, mean_fresnel_dielectric(ior));
    const Compensation c = compensate_reflection(surface, Color3f(mean_fresnel));
    const float blend = dielectric_albedo_blend(surface.roughness, surface.cos_o, ior);
    const float albedo = c.albedo.x * (f0 + (1.0f - f0) * blend);
    bsdf.add(dielectric_lobe(c.factor * weight, surface.normal, alpha_of(surface), ior),
             Color3f(albedo * weight));
    return albedo;
}

void add_glass(Bsdf& bsdf,
               const GgxSurface& surface,
               const Color3f& reflection,
               const Color3f& transmission,
               float ior)
{
    // Most light passes, so its colour stands for that of the bounces in between.
    const Compensation c = is_compensated(surface)
                               ? compensate(glass_energy(surface.roughness, surface.cos_o, ior),
                                            at_most_white(transmission))
                               : Compensation{};
    const float reflectance =
        fresnel_dielectric(std::clamp(surface.cos_o, 0.0f, 1.0f), ior).reflectance;
    const Color3f smooth = reflection * reflectance + transmission * (1.0f - reflectance);
    bsdf.add(glass_lobe(reflection * c.factor, transmission * c.factor, surface.normal,
                        alpha_of(surface), ior),
             smooth * c.albedo);
}

}  // namespace eye_render
