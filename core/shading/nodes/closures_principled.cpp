// The Principled BSDF as a node. Inputs of a layer that is not there are not evaluated.

#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/principled.h"
#include "shading/subsurface.h"

namespace eye_render {

namespace {

// clang-format off
enum Input : std::size_t {
    BaseColor, Metallic, Roughness, Ior, Alpha, Normal, DiffuseRoughness,
    SubsurfaceWeight, SubsurfaceRadius, SubsurfaceScale, SubsurfaceIor, SubsurfaceAnisotropy,
    SpecularIorLevel, SpecularTint, Anisotropic, AnisotropicRotation, Tangent,
    TransmissionWeight, CoatWeight, CoatRoughness, CoatIor, CoatTint, CoatNormal,
    SheenWeight, SheenRoughness, SheenTint, EmissionColor, EmissionStrength,
    ThinFilmThickness, ThinFilmIor,
};

constexpr auto inputs = std::to_array<InputSocket>({
    color_input("Base Color", 0.8f),
    number_input("Metallic", 0.0f),
    number_input("Roughness", 0.5f),
    number_input("IOR", 1.5f),
    number_input("Alpha", 1.0f),
    normal_input("Normal"),
    number_input("Diffuse Roughness", 0.0f),
    number_input("Subsurface Weight", 0.0f),
    {"Subsurface Radius", SocketType::Vector, NodeValue(1.0f, 0.2f, 0.1f)},
    number_input("Subsurface Scale", 0.05f),
    number_input("Subsurface IOR", 1.4f),
    number_input("Subsurface Anisotropy", 0.0f),
    number_input("Specular IOR Level", 0.5f),
    color_input("Specular Tint", 1.0f),
    number_input("Anisotropic", 0.0f),
    number_input("Anisotropic Rotation", 0.0f),
    tangent_input(),
    number_input("Transmission Weight", 0.0f),
    number_input("Coat Weight", 0.0f),
    number_input("Coat Roughness", 0.03f),
    number_input("Coat IOR", 1.5f),
    color_input("Coat Tint", 1.0f),
    normal_input("Coat Normal"),
    number_input("Sheen Weight", 0.0f),
    number_input("Sheen Roughness", 0.5f),
    color_input("Sheen Tint", 1.0f),
    color_input("Emission Color", 1.0f),
    number_input("Emission Strength", 0.0f),
    number_input("Thin Film Thickness", 0.0f),
    number_input("Thin Film IOR", 1.33f),
});
// clang-format on

class PrincipledNode : public ClosureNode {
public:
    PrincipledNode(const NodeOptions& options, WorkingSpace space)
        : multiple_scattering_(
              options.choice<bool>("distribution", {{"MULTI_GGX", true}, {"GGX", false}})),
          subsurface_method_(subsurface_method(options, "subsurface_method")),
          always_walks_(options.is_set("always_walks", false)), space_(space)
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs constants) const override
    {
        const auto may_have = [&](Input input) {
            return is_constantly_zero(constants, input) ? 0 : 1;
        };
        const bool is_opaque = constants[Alpha] && constants[Alpha]->x >= 1.0f;
        constexpr int specular_and_diffuse = 2;
        return {.may_be_transparent = !is_opaque,
                .may_emit = may_have(EmissionColor) * may_have(EmissionStrength) == 1,
                .lobes = specular_and_diffuse + (is_opaque ? 0 : 1) + may_have(Metallic) +
                         may_have(TransmissionWeight) + may_have(CoatWeight) +
                         may_have(SheenWeight) + subsurface_lobes * may_have(SubsurfaceWeight),
                .subsurface_normal = may_have(SubsurfaceWeight) == 1
                                         ? std::optional<std::size_t>(Normal)
                                         : std::nullopt};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const PrincipledInputs values = read(in);
        add_principled(shaded.bsdf, values, weight, point);
        if (values.emission_strength > 0.0f) {
            shaded.emission += principled_emission(values, point) * weight;
        }
    }

    [[nodiscard]] Color3f straight_transmittance(const NodeInputs& in) const override
    {
        return Color3f(1.0f - unit_range(in.number(Alpha)));
    }

    [[nodiscard]] Color3f emission(const NodeInputs& in) const override
    {
        PrincipledInputs values;
        read_emission(in, values);
        if (values.emission_strength == 0.0f) {
            return Color3f(0.0f);
        }
        values.alpha = in.number(Alpha);
        values.normal = in.vector(Normal);
        read_top_layers(in, values);
        return principled_emission(values, in.hit().point);
    }

private:
    static void read_emission(const NodeInputs& in, PrincipledInputs& values)
    {
        values.emission_strength = positive_range(in.number(EmissionStrength));
        if (values.emission_strength > 0.0f) {
            values.emission_color = in.color(EmissionColor);
        }
    }

    static void read_top_layers(const NodeInputs& in, PrincipledInputs& values)
    {
        values.coat_weight = in.number(CoatWeight);
        if (values.coat_weight > 0.0f) {
            values.coat_roughness = in.number(CoatRoughness);
            values.coat_ior = in.number(CoatIor);
            values.coat_tint = in.color(CoatTint);
            values.coat_normal = in.vector(CoatNormal);
        }
        values.sheen_weight = in.number(SheenWeight);
        if (values.sheen_weight > 0.0f) {
            values.sheen_roughness = in.number(SheenRoughness);
            values.sheen_tint = in.color(SheenTint);
        }
    }

    [[nodiscard]] PrincipledInputs read(const NodeInputs& in) const
    {
        PrincipledInputs values{
            .base_color = in.color(BaseColor),
            .metallic = in.number(Metallic),
            .roughness = in.number(Roughness),
            .ior = in.number(Ior),
            .alpha = in.number(Alpha),
            .normal = in.vector(Normal),
            .diffuse_roughness = in.number(DiffuseRoughness),
            .subsurface_weight = in.number(SubsurfaceWeight),
            .specular_ior_level = in.number(SpecularIorLevel),
            .specular_tint = in.color(SpecularTint),
            .anisotropic = in.number(Anisotropic),
            .transmission_weight = in.number(TransmissionWeight),
            .thin_film_thickness_nm = in.number(ThinFilmThickness),
            .multiple_scattering = multiple_scattering_,
            .subsurface_method = subsurface_method_,
            .working_space = space_,
            .shows_reflections = in.hit().path.shows_reflections,
            .shows_refractions = in.hit().path.shows_refractions,
        };
        if (values.subsurface_weight > 0.0f) {
            values.subsurface_radius = in.vector(SubsurfaceRadius);
            values.subsurface_scale = in.number(SubsurfaceScale);
            values.subsurface_ior = in.number(SubsurfaceIor);
            values.subsurface_anisotropy = in.number(SubsurfaceAnisotropy);
            values.after_diffuse = in.hit().path.diffuse_depth > 0;
            values.subsurface_always_walks = always_walks_;
        }
        if (values.anisotropic > 0.0f) {
            values.anisotropic_rotation = in.number(AnisotropicRotation);
            values.tangent = tangent_input_value(in, Tangent);
        }
        if (values.thin_film_thickness_nm > 0.0f) {
            values.thin_film_ior = in.number(ThinFilmIor);
        }
        read_top_layers(in, values);
        read_emission(in, values);
        return values;
    }

    bool multiple_scattering_;
    LobeKind subsurface_method_;
    bool always_walks_;
    WorkingSpace space_;
};

constexpr auto options =
    std::to_array<std::string_view>({"distribution", "subsurface_method", "always_walks"});

}  // namespace

NodeType principled_node()
{
    return closure_type<PrincipledNode>("BSDF_PRINCIPLED", inputs, bsdf_output, options);
}

}  // namespace eye_render
