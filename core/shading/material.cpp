// The surfaces of Material but Principled, and what is asked of all without their BSDF.

#include "shading/material.h"

#include "shading/ggx_surface.h"
#include "shading/material_input.h"
#include "shading/principled.h"
#include "shading/shading_normal.h"

namespace eye_render {

namespace {

[[nodiscard]] bool is_constantly(const MaterialInput& input, float value)
{
    return input.is_constant() && input.constant == Color3f(value);
}

[[nodiscard]] GgxSurface ggx_surface(const Material& material,
                                     const ShadingPoint& point,
                                     const HitAttributes& attributes)
{
    const V3f normal = visible_normal(mapped_normal(material, point, attributes), point);
    return {
        .normal = normal,
        .cos_o = normal.dot(point.wo),
        .roughness = read_scalar(material.roughness, attributes, 0.0f, 1.0f),
        .multiple_scattering = material.multiple_scattering,
    };
}

}  // namespace

bool Material::may_be_transparent() const
{
    switch (surface) {
    case Surface::Principled: return !(alpha.is_constant() && alpha.constant.x >= 1.0f);
    case Surface::Transparent: return !is_constantly(base_color, 0.0f);
    default: return false;
    }
}

bool Material::may_emit() const
{
    return (surface == Surface::Principled || surface == Surface::Emission) &&
           !is_constantly(emission_color, 0.0f) && !is_constantly(emission_strength, 0.0f);
}

ShadedPoint shade(const Material& material,
                  const ShadingPoint& point,
                  const HitAttributes& attributes)
{
    if (material.surface == Surface::Principled) {
        return shade_principled(material, point, attributes);
    }
    if (material.surface == Surface::Emission) {
        return {.bsdf = Bsdf(point.wo, point.ng),
                .emission = emitted_radiance(material, attributes)};
    }

    ShadedPoint shaded{.bsdf = Bsdf(point.wo, point.ng)};
    const Color3f color = read_color(material.base_color, attributes);
    switch (material.surface) {
    case Surface::Diffuse: {
        const V3f normal = mapped_normal(material, point, attributes);
        shaded.bsdf.add(diffuse_lobe(color, normal, point.ns), color);
        break;
    }
    case Surface::Glossy:
        add_glossy(shaded.bsdf, ggx_surface(material, point, attributes), color);
        break;
    case Surface::Glass: {
        const float ior = read_ior(material.ior, attributes);
        add_glass(shaded.bsdf, ggx_surface(material, point, attributes), 1.0f, color, color,
                  point.backfacing ? 1.0f / ior : ior);
        break;
    }
    default: shaded.bsdf.add(straight_lobe(color), color); break;
    }
    return shaded;
}

Color3f straight_transmittance(const Material& material, const HitAttributes& attributes)
{
    switch (material.surface) {
    case Surface::Principled:
        return Color3f(1.0f - read_scalar(material.alpha, attributes, 0.0f, 1.0f));
    case Surface::Transparent: return read_color(material.base_color, attributes);
    default: return Color3f(0.0f);
    }
}

Color3f emitted_radiance(const Material& material, const HitAttributes& attributes)
{
    if (!material.may_emit()) {
        return Color3f(0.0f);
    }
    const Color3f color = read_color(material.emission_color, attributes);
    constexpr float largest_strength = 1e8f;
    const Color3f radiance =
        color * read_scalar(material.emission_strength, attributes, 0.0f, largest_strength);
    return material.surface == Surface::Principled
               ? radiance * read_scalar(material.alpha, attributes, 0.0f, 1.0f)
               : radiance;
}

}  // namespace eye_render
