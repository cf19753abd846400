// The layers of the Principled BSDF from the top, as Cycles stacks them: what one layer takes is
// gone for those below.

#include "shading/principled.h"

#include "shading/fresnel.h"
#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/node.h"
#include "shading/visible_normal.h"

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

void add_principled(Bsdf& bsdf,
                    const PrincipledInputs& inputs,
                    float weight,
                    const ShadingPoint& point)
{
    const float alpha = unit_range(inputs.alpha);
    if (alpha < 1.0f) {
        const Color3f passing((1.0f - alpha) * weight);
        bsdf.add(straight_lobe(passing), passing);
        weight *= alpha;
    }
    if (weight == 0.0f) {
        return;
    }

    const Color3f base_color = positive_range(inputs.base_color);
    const Color3f clamped_color = unit_range(base_color);
    const float metallic = unit_range(inputs.metallic);
    const float transmission = unit_range(inputs.transmission_weight);
    const float ior = ior_range(inputs.ior);
    const V3f normal = unit_normal(inputs.normal, point.ns);
    const V3f mirror_normal = visible_normal(normal, point.wo, point.ng);
    const GgxSurface surface{
        .normal = mirror_normal,
        .cos_o = mirror_normal.dot(point.wo),
        .roughness = unit_range(inputs.roughness),
        .multiple_scattering = inputs.multiple_scattering,
    };

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
        const float specular = in_range(inputs.specular_ior_level, 0.0f, largest_specular);
        const float polish_ior = adjusted_ior(ior, specular);
        if (polish_ior != 1.0f) {
            const float kept = add_dielectric(bsdf, surface, weight, polish_ior);
            weight *= std::clamp(1.0f - kept, 0.0f, 1.0f);
        }
        const Color3f diffuse = base_color * weight;
        bsdf.add(diffuse_lobe(diffuse, normal, point.ns), diffuse);
    }
}

Color3f principled_emission(const PrincipledInputs& inputs, const ShadingPoint& /*point*/)
{
    return positive_range(inputs.emission_color) * positive_range(inputs.emission_strength) *
           unit_range(inputs.alpha);
}

}  // namespace eye_render
