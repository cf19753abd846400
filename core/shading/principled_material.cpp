// The Principled BSDF for the inputs of Material.

#include "shading/material_input.h"
#include "shading/principled.h"
#include "shading/shading_normal.h"

namespace eye_render {

ShadedPoint shade_principled(const Material& material,
                             const ShadingPoint& point,
                             const HitAttributes& attributes)
{
    ShadedPoint shaded{.bsdf = Bsdf(point.wo, point.ng)};
    PrincipledInputs inputs{
        .base_color = read_color(material.base_color, attributes),
        .metallic = read_scalar(material.metallic, attributes, 0.0f, 1.0f),
        .roughness = read_scalar(material.roughness, attributes, 0.0f, 1.0f),
        .ior = read_ior(material.ior, attributes),
        .alpha = read_scalar(material.alpha, attributes, 0.0f, 1.0f),
        .normal = mapped_normal(material, point, attributes),
        .specular_ior_level = read_scalar(material.specular, attributes, 0.0f, 1e3f),
        .transmission_weight = read_scalar(material.transmission, attributes, 0.0f, 1.0f),
        .multiple_scattering = material.multiple_scattering,
    };
    if (material.may_emit()) {
        inputs.emission_color = read_color(material.emission_color, attributes);
        inputs.emission_strength = read_scalar(material.emission_strength, attributes, 0.0f, 1e8f);
        shaded.emission = principled_emission(inputs, point);
    }
    add_principled(shaded.bsdf, inputs, 1.0f, point);
    return shaded;
}

}  // namespace eye_render
