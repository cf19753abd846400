// Weights and albedos of the GGX lobes.

#include "shading/ggx_surface.h"

#include "shading/energy_tables.h"
#include "shading/fresnel.h"

#include <algorithm>

namespace eye_render {

namespace {

[[nodiscard]] float alpha_of(const GgxSurface& surface)
{
    return surface.roughness * surface.roughness;
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

// For a reflecting lobe.
[[nodiscard]] Compensation compensate(const Lobe& lobe,
                                      const GgxSurface& surface,
                                      const Color3f& mean_fresnel)
{
    // A mirror loses nothing.
    return surface.multiple_scattering && !lobe.is_delta()
               ? compensate(reflection_energy(surface.roughness, surface.cos_o), mean_fresnel)
               : Compensation{};
}

}  // namespace

void add_glossy(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color, float weight)
{
    Lobe lobe = glossy_lobe(color * weight, surface.normal, alpha_of(surface));
    const Compensation c = compensate(lobe, surface, at_most_white(color));
    lobe.weight *= c.factor;
    bsdf.add(lobe, color * c.albedo * weight);
}

void add_metal(Bsdf& bsdf, const GgxSurface& surface, float weight, const Color3f& f0)
{
    Lobe lobe = metal_lobe(Color3f(weight), surface.normal, alpha_of(surface), f0);
    const Compensation c = compensate(lobe, surface, blend_to_white(f0, mean_schlick_blend));
    lobe.weight *= c.factor;
    const float blend = schlick_albedo_blend(surface.roughness, surface.cos_o);
    bsdf.add(lobe, c.albedo * blend_to_white(f0, blend) * weight);
}

float add_dielectric(Bsdf& bsdf, const GgxSurface& surface, float weight, float ior)
{
    Lobe lobe = dielectric_lobe(Color3f(weight), surface.normal, alpha_of(surface), ior);
    const float f0 = f0_from_ior(ior);
    const Color3f mean_fresnel(std::max(f0, mean_fresnel_dielectric(ior)));
    const Compensation c = compensate(lobe, surface, mean_fresnel);
    lobe.weight *= c.factor;
    const float blend = dielectric_albedo_blend(surface.roughness, surface.cos_o, ior);
    const float albedo = c.albedo.x * (f0 + (1.0f - f0) * blend);
    bsdf.add(lobe, Color3f(albedo * weight));
    return albedo;
}

void add_glass(Bsdf& bsdf,
               const GgxSurface& surface,
               float weight,
               const Color3f& reflection,
               const Color3f& transmission,
               float ior)
{
    Lobe lobe = glass_lobe(reflection * weight, transmission * weight, surface.normal,
                           alpha_of(surface), ior);
    Compensation c;
    if (surface.multiple_scattering && !lobe.is_delta()) {
        // Most light passes, so its colour stands for that of the bounces in between.
        c = compensate(glass_energy(surface.roughness, surface.cos_o, ior),
                       at_most_white(transmission));
    }
    lobe.weight *= c.factor;
    lobe.transmission *= c.factor;
    // As of smooth glass.
    const float reflected =
        fresnel_dielectric(std::clamp(surface.cos_o, 0.0f, 1.0f), ior).reflectance;
    bsdf.add(lobe,
             (reflection * reflected + transmission * (1.0f - reflected)) * c.albedo * weight);
}

}  // namespace eye_render
