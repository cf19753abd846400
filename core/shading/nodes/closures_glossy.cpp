// Closures of microfacets: Glossy, Metallic, Glass and Refraction.

#include "shading/ggx_surface.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

#include <cmath>

namespace eye_render {

namespace {

enum class Distribution { MultiGgx, Ggx, Beckmann, AshikhminShirley };

class FacetNode : public ClosureNode {
public:
    explicit FacetNode(const NodeOptions& options)
        : distribution_(options.choice<Distribution>(
              "distribution",
              {{"MULTI_GGX", Distribution::MultiGgx},
               {"GGX", Distribution::Ggx},
               {"BECKMANN", Distribution::Beckmann},
               {"ASHIKHMIN_SHIRLEY", Distribution::AshikhminShirley}}))
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

protected:
    [[nodiscard]] GgxSurface surface(const ShadingPoint& point,
                                     const V3f& normal,
                                     float roughness) const
    {
        const V3f mirror_normal =
            visible_normal(unit_normal(normal, point.ns), point.wo, point.ng);
        return {.normal = mirror_normal,
                .cos_o = mirror_normal.dot(point.wo),
                .roughness = unit_range(roughness),
                .multiple_scattering = distribution_ == Distribution::MultiGgx,
                .facets = distribution_ == Distribution::Beckmann ? FacetModel::Beckmann
                                                                  : FacetModel::Ggx};
    }

    [[nodiscard]] bool is_phong() const { return distribution_ == Distribution::AshikhminShirley; }

private:
    Distribution distribution_;
};

class GlossyNode : public FacetNode {
public:
    enum Input : std::size_t { Color, Roughness, Anisotropy, Rotation, Normal, Tangent };

    using FacetNode::FacetNode;

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        if (!in.hit().path.shows_reflections) {
            return;
        }
        GgxSurface facets = surface(in.hit().point, in.vector(Normal), in.number(Roughness));
        const float anisotropy = in_range(in.number(Anisotropy), -0.99f, 0.99f);
        constexpr float least_anisotropy = 1e-4f;
        if (std::abs(anisotropy) > least_anisotropy) {
            // Narrow along the tangent for a positive one.
            const float stretch =
                anisotropy > 0.0f ? 1.0f - anisotropy : 1.0f / (1.0f + anisotropy);
            brush(facets, stretch, 1.0f / stretch, tangent_input_value(in, Tangent),
                  in.number(Rotation), facets.normal);
        }
        const Color3f color = positive_range(in.color(Color));
        if (is_phong()) {
            add_phong(shaded.bsdf, facets, color * weight);
        } else {
            add_glossy(shaded.bsdf, facets, weight, color);
        }
    }
};

class MetallicNode : public FacetNode {
public:
    enum Input : std::size_t {
        BaseColor,
        EdgeTint,
        Ior,
        Extinction,
        Roughness,
        Anisotropy,
        Rotation,
        Normal,
        Tangent
    };

    explicit MetallicNode(const NodeOptions& options)
        : FacetNode(options),
          is_physical_(
              options.choice<bool>("fresnel_type", {{"F82", false}, {"PHYSICAL_CONDUCTOR", true}}))
    {
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        if (!in.hit().path.shows_reflections) {
            return;
        }
        const ShadingPoint& point = in.hit().point;
        const V3f normal = in.vector(Normal);
        GgxSurface facets = surface(point, normal, in.number(Roughness));
        const float anisotropy = unit_range(in.number(Anisotropy));
        if (anisotropy > 0.0f) {
            const float aspect = std::sqrt(1.0f - 0.9f * anisotropy);
            brush(facets, 1.0f / aspect, aspect, tangent_input_value(in, Tangent),
                  in.number(Rotation), unit_normal(normal, point.ns));
        }
        if (is_physical_) {
            add_conductor(shaded.bsdf, facets, weight, positive_range(in.color(Ior)),
                          positive_range(in.color(Extinction)));
        } else {
            add_metal(shaded.bsdf, facets, Color3f(weight), unit_range(in.color(BaseColor)),
                      unit_range(in.color(EdgeTint)));
        }
    }

private:
    bool is_physical_;
};

class GlassNode : public FacetNode {
public:
    enum Input : std::size_t { Color, Roughness, Ior, Normal };

    using FacetNode::FacetNode;

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const PathState& path = in.hit().path;
        const Color3f color = positive_range(in.color(Color));
        const float ior = ior_range(in.number(Ior));
        const Color3f none(0.0f);
        add_glass(shaded.bsdf, surface(point, in.vector(Normal), in.number(Roughness)),
                  Color3f(weight), path.shows_reflections ? color : none,
                  path.shows_refractions ? color : none,
                  {.ior = point.backfacing ? 1.0f / ior : ior});
    }
};

class RefractionNode : public FacetNode {
public:
    enum Input : std::size_t { Color, Roughness, Ior, Normal };

    using FacetNode::FacetNode;

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        if (!in.hit().path.shows_refractions) {
            return;
        }
        const ShadingPoint& point = in.hit().point;
        const float ior = ior_range(in.number(Ior));
        add_refraction(shaded.bsdf, surface(point, in.vector(Normal), in.number(Roughness)),
                       positive_range(in.color(Color)) * weight,
                       point.backfacing ? 1.0f / ior : ior);
    }
};

constexpr auto distribution_options = std::to_array<std::string_view>({"distribution"});

}  // namespace

NodeType glossy_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {color_input("Color", 0.8f), number_input("Roughness", 0.5f),
         number_input("Anisotropy", 0.0f), number_input("Rotation", 0.0f), normal_input("Normal"),
         tangent_input()});
    return closure_type<GlossyNode>("BSDF_GLOSSY", inputs, bsdf_output, distribution_options);
}

NodeType metallic_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {{"Base Color", SocketType::Color, NodeValue(0.617f, 0.577f, 0.540f)},
         {"Edge Tint", SocketType::Color, NodeValue(0.695f, 0.726f, 0.770f)},
         {"IOR", SocketType::Vector, NodeValue(2.757f, 2.513f, 2.231f)},
         {"Extinction", SocketType::Vector, NodeValue(3.867f, 3.404f, 3.009f)},
         number_input("Roughness", 0.5f),
         number_input("Anisotropy", 0.0f),
         number_input("Rotation", 0.0f),
         normal_input("Normal"),
         tangent_input()});
    static constexpr auto options =
        std::to_array<std::string_view>({"distribution", "fresnel_type"});
    return closure_type<MetallicNode>("BSDF_METALLIC", inputs, bsdf_output, options);
}

NodeType glass_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 1.0f), number_input("Roughness", 0.0f),
                                    number_input("IOR", 1.5f), normal_input("Normal")});
    return closure_type<GlassNode>("BSDF_GLASS", inputs, bsdf_output, distribution_options);
}

NodeType refraction_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 1.0f), number_input("Roughness", 0.0f),
                                    number_input("IOR", 1.45f), normal_input("Normal")});
    return closure_type<RefractionNode>("BSDF_REFRACTION", inputs, bsdf_output,
                                        distribution_options);
}

}  // namespace eye_render
