// Closures of hair: one lobe of a fibre, in a simple way, or all of them.

#include "shading/diffuse_lobe.h"
#include "shading/fibre_lobe.h"
#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

[[nodiscard]] GgxSurface fibre_surface(const ShadingPoint& point, float roughness)
{
    const V3f normal = visible_normal(point.ns, point.wo, point.ng);
    return {.normal = normal,
            .cos_o = normal.dot(point.wo),
            .roughness = unit_range(roughness),
            .multiple_scattering = true};
}

// Along the strand, or along the first UV map's u.
[[nodiscard]] V3f strand_tangent(const NodeInputs& in)
{
    return in.hit().attributes.tangent(HitAttributes::active_uv_layer).tangent;
}

class HairNode final : public ClosureNode {
public:
    enum Input : std::size_t { Color, RoughnessAlong, RoughnessAround, Tangent };

    explicit HairNode(const NodeOptions& options)
        : is_reflection_(
              options.choice<bool>("component", {{"Reflection", true}, {"Transmission", false}}))
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = unit_range(in.color(Color));
        GgxSurface fibre = fibre_surface(point, 1.0f);
        if (!is_reflection_) {
            shaded.bsdf.add(translucent_lobe(color * weight, fibre.normal, point.ns),
                            color * weight);
            return;
        }
        // The normals turn around the strand, so all gloss around it is theirs.
        const float along = std::sqrt(std::max(unit_range(in.number(RoughnessAlong)), 1e-3f));
        const float around = std::sqrt(std::max(unit_range(in.number(RoughnessAround)), 1e-3f));
        const V3f linked = in.vector(Tangent);
        brush(fibre, along * along, around * around,
              linked.length2() > 0.0f ? linked : strand_tangent(in), 0.0f, fibre.normal);
        add_glossy(shaded.bsdf, fibre, weight, color);
    }

private:
    bool is_reflection_;
};

// What a fibre absorbs over its radius for much hair to have that colour: Chiang, Bitterli, Tappan
// & Burley 2016, "A Practical and Controllable Hair and Fur Model", eq. 9. `roughness` is the
// radial one.
[[nodiscard]] Color3f absorption_of(const Color3f& color, float roughness)
{
    const float b = roughness;
    const float scale =
        5.969f + b * (-0.215f + b * (2.532f + b * (-10.73f + b * (5.574f + b * 0.245f))));
    const auto of = [scale](float value) {
        const float root = std::log(std::max(value, 1e-5f)) / scale;
        return root * root;
    };
    return {of(color.x), of(color.y), of(color.z)};
}

class PrincipledHairNode final : public ClosureNode {
public:
    enum Input : std::size_t {
        Color,
        Melanin,
        Redness,
        Tint,
        Absorption,
        Roughness,
        RadialRoughness,
        Coat,
        Ior,
        Offset,
        RandomColor,
        RandomRoughness,
        Random,
    };
    enum class Parametrization { Color, Melanin, Absorption };

    explicit PrincipledHairNode(const NodeOptions& options)
        : parametrization_(
              options.choice<Parametrization>("parametrization",
                                              {{"COLOR", Parametrization::Color},
                                               {"MELANIN", Parametrization::Melanin},
                                               {"ABSORPTION", Parametrization::Absorption}}))
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const float variation = 1.0f + deviation(in) * in.number(RandomRoughness);
        const float radial_roughness = in.number(RadialRoughness) * variation;
        const Lobe lobe = fibre_lobe(weight,
                                     {.absorption = absorption(in, radial_roughness),
                                      .roughness = in.number(Roughness) * variation,
                                      .radial_roughness = radial_roughness,
                                      .gloss_roughness = 1.0f - unit_range(in.number(Coat)),
                                      .ior = in.number(Ior),
                                      .tilt_rad = in.number(Offset)},
                                     strand_tangent(in), point.ng);
        const FibreAlbedo albedo = fibre_albedo(lobe, point.wo);
        shaded.bsdf.add(lobe, albedo.reflected + albedo.transmitted, albedo.transmitted);
    }

private:
    // Of this strand from the mean, -1 to 1.
    [[nodiscard]] static float deviation(const NodeInputs& in)
    {
        return 2.0f * (in.number(Random) - 0.5f);
    }

    [[nodiscard]] Color3f absorption(const NodeInputs& in, float radial_roughness) const
    {
        switch (parametrization_) {
        case Parametrization::Color: break;
        case Parametrization::Absorption: return in.color(Absorption);
        case Parametrization::Melanin: {
            // Absorption of eumelanin and pheomelanin: d'Eon, Francois, Hill, Letteri & Aubry
            // 2011, "An Energy-Conserving Hair Reflectance Model"; the amount as Blender asks.
            const Color3f eumelanin(0.506f, 0.841f, 1.653f);
            const Color3f pheomelanin(0.343f, 0.733f, 1.924f);
            const float melanin =
                in.number(Melanin) * (1.0f + deviation(in) * unit_range(in.number(RandomColor)));
            const float amount = -std::log(std::max(1.0f - melanin, 1e-4f));
            const float redness = in.number(Redness);
            return eumelanin * (amount * (1.0f - redness)) + pheomelanin * (amount * redness) +
                   absorption_of(in.color(Tint), radial_roughness);
        }
        }
        return absorption_of(in.color(Color), radial_roughness);
    }

    Parametrization parametrization_;
};

constexpr std::array hair_in{color_input("Color", 0.8f), number_input("RoughnessU", 0.1f),
                             number_input("RoughnessV", 1.0f), tangent_input()};
constexpr std::array principled_hair_in{
    InputSocket{"Color", SocketType::Color, NodeValue(0.017513f, 0.005763f, 0.002059f)},
    number_input("Melanin", 0.8f),
    number_input("Melanin Redness", 1.0f),
    color_input("Tint", 1.0f),
    vector_input("Absorption Coefficient", {0.245531f, 0.52f, 1.365f}),
    number_input("Roughness", 0.3f),
    number_input("Radial Roughness", 0.3f),
    number_input("Coat"),
    number_input("IOR", 1.55f),
    number_input("Offset", 2.0f * std::numbers::pi_v<float> / 180.0f),
    number_input("Random Color"),
    number_input("Random Roughness"),
    InputSocket{"Random", SocketType::Number, NodeValue(0.0f), ImplicitInput::StrandRandom}};
constexpr std::array<std::string_view, 1> hair_options{"component"};
constexpr std::array<std::string_view, 1> principled_hair_options{"parametrization"};

}  // namespace

NodeType hair_node()
{
    return closure_type<HairNode>("BSDF_HAIR", hair_in, bsdf_output, hair_options);
}

NodeType principled_hair_node()
{
    return closure_type<PrincipledHairNode>("BSDF_HAIR_PRINCIPLED", principled_hair_in,
                                            bsdf_output, principled_hair_options);
}

}  // namespace eye_render
