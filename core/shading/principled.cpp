// The layers of the Principled BSDF from the top, as Cycles stacks them: what one layer takes is
// gone for those below.

#include "shading/principled.h"

#include "shading/fresnel.h"
#include "shading/ggx_surface.h"
#include "shading/material_input.h"
#include "shading/shading_normal.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

constexpr float largest_specular = 1e3f;

// What the specular level makes of the index: it scales the reflectance at normal incidence, and
// 0.5 leaves it. An index below 1 stays below.
[[nodiscard]] float adjusted_ior(float ior, float specular)
{
    if (specular == 0.5f) {
        return ior;
    }
    const float denser = ior_from_f0(f0_from_ior(ior) * 2.0f * specular);
    return ior < 1.0f ? 1.0f / denser : denser;
}

[[nodiscard]] Color3f sqrt_of(const Color3f& c)
{
    return {std::sqrt(c.x), std::sqrt(c.y), std::sqrt(c.z)};
}

}  // namespace

ShadedPoint shade_principled(const Material& material,
                             const ShadingPoint& point,
                             const HitAttributes& attributes)
{
    ShadedPoint shaded{.bsdf = Bsdf(point.wo, point.ng)};
    Bsdf& bsdf = shaded.bsdf;

    const float alpha = read_scalar(material.alpha, attributes, 0.0f, 1.0f);
    if (alpha < 1.0f) {
        bsdf.add(straight_lobe(Color3f(1.0f - alpha)), Color3f(1.0f - alpha));
    }
    if (alpha == 0.0f) {
        return shaded;
    }
    if (material.may_emit()) {
        shaded.emission = emitted_radiance(material, attributes);
    }

    const Color3f base_color = read_color(material.base_color, attributes);
    const Color3f clamped_color(std::min(base_color.x, 1.0f), std::min(base_color.y, 1.0f),
                                std::min(base_color.z, 1.0f));
    const float metallic = read_scalar(material.metallic, attributes, 0.0f, 1.0f);
    const float transmission = read_scalar(material.transmission, attributes, 0.0f, 1.0f);
    const float ior = read_ior(material.ior, attributes);
    const V3f normal = mapped_normal(material, point, attributes);
    const V3f mirror_normal = visible_normal(normal, point);
    const GgxSurface surface{
        .normal = mirror_normal,
        .cos_o = mirror_normal.dot(point.wo),
        .roughness = read_scalar(material.roughness, attributes, 0.0f, 1.0f),
        .multiple_scattering = material.multiple_scattering,
    };

    float weight = alpha;
    if (metallic > 0.0f) {
        add_metal(bsdf, surface, weight * metallic, clamped_color);
        weight *= 1.0f - metallic;
    }
    if (transmission > 0.0f && weight > 0.0f) {
        add_glass(bsdf, surface, weight * transmission, Color3f(1.0f), sqrt_of(clamped_color),
                  point.backfacing ? 1.0f / ior : ior);
        weight *= 1.0f - transmission;
    }
    if (weight > 0.0f) {
        const float specular = read_scalar(material.specular, attributes, 0.0f, largest_specular);
        const float polish_ior = adjusted_ior(ior, specular);
        if (polish_ior != 1.0f) {
            const float kept = add_dielectric(bsdf, surface, weight, polish_ior);
            weight *= std::clamp(1.0f - kept, 0.0f, 1.0f);
        }
        const Color3f diffuse = base_color * weight;
        bsdf.add(diffuse_lobe(diffuse, normal, point.ns), diffuse);
    }
    return shaded;
}

}  // namespace eye_render
