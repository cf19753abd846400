// Closures that scatter widely.

#include "shading/diffuse_lobe.h"
#include "shading/glossy_lobe.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

namespace eye_render {

namespace {

// Of one lobe that is not transparent.
class OneLobeNode : public ClosureNode {
public:
    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }
};

class DiffuseNode : public OneLobeNode {
public:
    enum Input : std::size_t { Color, Roughness, Normal };

    explicit DiffuseNode(const NodeOptions& /*options*/) {}

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color));
        const V3f normal = unit_normal(in.vector(Normal), point.ns);
        const float roughness = unit_range(in.number(Roughness));
        if (roughness > 0.0f) {
            const LobeAndAlbedo rough =
                oren_nayar_lobe(color * weight, color, roughness, normal, point.ns, point.wo);
            shaded.bsdf.add(rough.lobe, rough.albedo);
        } else {
            shaded.bsdf.add(diffuse_lobe(color * weight, normal, point.ns), color * weight);
        }
    }
};

class TranslucentNode : public OneLobeNode {
public:
    enum Input : std::size_t { Color, Normal };

    explicit TranslucentNode(const NodeOptions& /*options*/) {}

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color)) * weight;
        const V3f normal =
            visible_normal(unit_normal(in.vector(Normal), point.ns), point.wo, point.ng);
        shaded.bsdf.add(translucent_lobe(color, normal, point.ns), color);
    }
};

class ToonNode : public OneLobeNode {
public:
    enum Input : std::size_t { Color, Size, Smooth, Normal };

    explicit ToonNode(const NodeOptions& options)
        : kind_(options.choice<LobeKind>(
              "component",
              {{"DIFFUSE", LobeKind::DiffuseToon}, {"GLOSSY", LobeKind::GlossyToon}}))
    {
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        if (kind_ == LobeKind::GlossyToon && !in.hit().path.shows_reflections) {
            return;
        }
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color)) * weight;
        shaded.bsdf.add(toon_lobe(kind_, color, in.number(Size), in.number(Smooth),
                                  unit_normal(in.vector(Normal), point.ns), point.ns),
                        color);
    }

private:
    LobeKind kind_;
};

class SheenNode : public OneLobeNode {
public:
    enum Input : std::size_t { Color, Roughness, Normal };

    explicit SheenNode(const NodeOptions& options)
        : is_velvet_(
              options.choice<bool>("distribution", {{"MICROFIBER", false}, {"ASHIKHMIN", true}}))
    {
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color)) * weight;
        const float roughness = unit_range(in.number(Roughness));
        const V3f normal = unit_normal(in.vector(Normal), point.ns);
        if (is_velvet_) {
            shaded.bsdf.add(velvet_lobe(color, normal, roughness), color);
        } else {
            static_cast<void>(
                add_sheen(shaded.bsdf, color, roughness, normal, point.ns, point.wo));
        }
    }

private:
    bool is_velvet_;
};

}  // namespace

NodeType diffuse_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {color_input("Color", 0.8f), number_input("Roughness", 0.0f), normal_input("Normal")});
    return closure_type<DiffuseNode>("BSDF_DIFFUSE", inputs);
}

NodeType translucent_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 0.8f), normal_input("Normal")});
    return closure_type<TranslucentNode>("BSDF_TRANSLUCENT", inputs);
}

NodeType toon_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 0.8f), number_input("Size", 0.5f),
                                    number_input("Smooth", 0.0f), normal_input("Normal")});
    static constexpr auto options = std::to_array<std::string_view>({"component"});
    return closure_type<ToonNode>("BSDF_TOON", inputs, bsdf_output, options);
}

NodeType sheen_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {color_input("Color", 0.8f), number_input("Roughness", 0.5f), normal_input("Normal")});
    static constexpr auto options = std::to_array<std::string_view>({"distribution"});
    return closure_type<SheenNode>("BSDF_SHEEN", inputs, bsdf_output, options);
}

}  // namespace eye_render
