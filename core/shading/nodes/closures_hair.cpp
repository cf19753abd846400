// Closures of hair, as mixtures of a fibre's gloss and of what it scatters around itself. The
// lobes of light that goes through a fibre once or twice are not told apart.

#include "shading/diffuse_lobe.h"
#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

#include <cmath>

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
        brush(fibre, along * along, around * around, strand_tangent(in), 0.0f, fibre.normal);
        add_glossy(shaded.bsdf, fibre, weight, color);
    }

private:
    // Linked, or along the strand, or along the first UV map's u.
    [[nodiscard]] static V3f strand_tangent(const NodeInputs& in)
    {
        const V3f linked = in.vector(Tangent);
        return linked.length2() > 0.0f
                   ? linked
                   : in.hit().attributes.tangent(HitAttributes::active_uv_layer).tangent;
    }

    bool is_reflection_;
};

// How the colour of much hair follows from what one fibre absorbs over its radius, and back:
// Chiang, Bitterli, Tappan & Burley 2016, "A Practical and Controllable Hair and Fur Model",
// equation 9. `roughness` is the azimuthal one.
[[nodiscard]] float absorption_scale(float roughness)
{
    const float b = roughness;
    return 5.969f + b * (-0.215f + b * (2.532f + b * (-10.73f + b * (5.574f + b * 0.245f))));
}

[[nodiscard]] Color3f absorption_of(const Color3f& color, float roughness)
{
    const float scale = absorption_scale(roughness);
    const auto of = [scale](float value) {
        const float root = std::log(std::clamp(value, 1e-5f, 1.0f)) / scale;
        return root * root;
    };
    return {of(color.x), of(color.y), of(color.z)};
}

[[nodiscard]] Color3f color_of(const Color3f& absorption, float roughness)
{
    const float scale = absorption_scale(roughness);
    const auto of = [scale](float value) { return std::exp(-scale * std::sqrt(value)); };
    return {of(absorption.x), of(absorption.y), of(absorption.z)};
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
        Ior
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
        return {.lobes = 3};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const GgxSurface fibre = fibre_surface(point, in.number(Roughness));
        const float kept = add_dielectric(shaded.bsdf, fibre, Color3f(weight),
                                          {.ior = std::max(ior_range(in.number(Ior)), 1.0f)});
        // As much comes back as passes to the other side.
        const Color3f half = color(in) * (0.5f * weight * (1.0f - kept));
        shaded.bsdf.add(diffuse_lobe(half, fibre.normal, point.ns), half);
        shaded.bsdf.add(translucent_lobe(half, fibre.normal, point.ns), half);
    }

private:
    [[nodiscard]] Color3f color(const NodeInputs& in) const
    {
        const float roughness = unit_range(in.number(RadialRoughness));
        switch (parametrization_) {
        case Parametrization::Color: break;
        case Parametrization::Absorption:
            return color_of(positive_range(in.color(Absorption)), roughness);
        case Parametrization::Melanin: {
            // Absorption of eumelanin and pheomelanin: d'Eon, Francois, Hill, Letteri & Aubry
            // 2011, "An Energy-Conserving Hair Reflectance Model"; the amount as Blender asks.
            const Color3f eumelanin(0.506f, 0.841f, 1.653f);
            const Color3f pheomelanin(0.343f, 0.733f, 1.924f);
            const float amount = -std::log(std::max(1.0f - unit_range(in.number(Melanin)), 1e-4f));
            const float redness = unit_range(in.number(Redness));
            return color_of(eumelanin * (amount * (1.0f - redness)) +
                                pheomelanin * (amount * redness) +
                                absorption_of(in.color(Tint), roughness),
                            roughness);
        }
        }
        return unit_range(in.color(Color));
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
    number_input("IOR", 1.55f)};
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
