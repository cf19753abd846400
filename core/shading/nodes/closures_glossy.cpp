// Closures of microfacets: Glossy and Glass.

#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

namespace eye_render {

namespace {

enum class Distribution { MultiGgx, Ggx, Beckmann, AshikhminShirley };

[[nodiscard]] Distribution distribution_option(const NodeOptions& options)
{
    return options.choice<Distribution>("distribution",
                                        {{"MULTI_GGX", Distribution::MultiGgx},
                                         {"GGX", Distribution::Ggx},
                                         {"BECKMANN", Distribution::Beckmann},
                                         {"ASHIKHMIN_SHIRLEY", Distribution::AshikhminShirley}});
}

[[nodiscard]] GgxSurface surface_at(const ShadingPoint& point,
                                    const V3f& normal,
                                    float roughness,
                                    Distribution distribution)
{
    const V3f mirror_normal = visible_normal(unit_normal(normal, point.ns), point.wo, point.ng);
    return {.normal = mirror_normal,
            .cos_o = mirror_normal.dot(point.wo),
            .roughness = unit_range(roughness),
            .multiple_scattering = distribution == Distribution::MultiGgx};
}

class GlossyNode : public ClosureNode {
public:
    enum Input : std::size_t { Color, Roughness, Anisotropy, Rotation, Normal, Tangent };

    explicit GlossyNode(const NodeOptions& options) : distribution_(distribution_option(options))
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        add_glossy(
            shaded.bsdf,
            surface_at(in.hit().point, in.vector(Normal), in.number(Roughness), distribution_),
            positive_range(in.color(Color)), weight);
    }

private:
    Distribution distribution_;
};

class GlassNode : public ClosureNode {
public:
    enum Input : std::size_t { Color, Roughness, Ior, Normal };

    explicit GlassNode(const NodeOptions& options) : distribution_(distribution_option(options)) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color));
        const float ior = ior_range(in.number(Ior));
        add_glass(shaded.bsdf,
                  surface_at(point, in.vector(Normal), in.number(Roughness), distribution_),
                  weight, color, color, point.backfacing ? 1.0f / ior : ior);
    }

private:
    Distribution distribution_;
};

constexpr std::string_view distribution_options[] = {"distribution"};

}  // namespace

NodeType glossy_node()
{
    static constexpr InputSocket inputs[] = {
        color_input("Color", 0.8f),       number_input("Roughness", 0.5f),
        number_input("Anisotropy", 0.0f), number_input("Rotation", 0.0f),
        normal_input("Normal"),           {"Tangent", SocketType::Vector}};
    return closure_type<GlossyNode>("BSDF_GLOSSY", inputs, bsdf_output, distribution_options);
}

NodeType glass_node()
{
    static constexpr InputSocket inputs[] = {color_input("Color", 1.0f),
                                             number_input("Roughness", 0.0f),
                                             number_input("IOR", 1.5f), normal_input("Normal")};
    return closure_type<GlassNode>("BSDF_GLASS", inputs, bsdf_output, distribution_options);
}

}  // namespace eye_render
