// Light that is scattered below the surface.

#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/subsurface.h"
#include "shading/visible_normal.h"

namespace eye_render {

namespace {

class SubsurfaceNode : public ClosureNode {
public:
    enum Input : std::size_t { Color, Scale, Radius, Ior, Roughness, Anisotropy, Normal };

    explicit SubsurfaceNode(const NodeOptions& options)
        : method_(subsurface_method(options, "falloff")),
          always_walks_(options.is_set("always_walks", false))
    {
    }

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = subsurface_lobes, .subsurface_normal = Normal};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = unit_range(in.color(Color));
        // The roughness is the facets' alpha, as in Cycles.
        add_subsurface(shaded.bsdf,
                       {.method = method_,
                        .color = color,
                        .radius = Color3f(in.vector(Radius)) * in.number(Scale),
                        .alpha = in.number(Roughness),
                        .ior = in.number(Ior),
                        .anisotropy = in.number(Anisotropy),
                        .always_walks = always_walks_},
                       color * weight, unit_normal(in.vector(Normal), point.ns), point,
                       in.hit().path.diffuse_depth > 0);
    }

private:
    LobeKind method_;
    bool always_walks_;
};

}  // namespace

LobeKind subsurface_method(const NodeOptions& options, const std::string& name)
{
    return options.choice<LobeKind>(name, {{"RANDOM_WALK", LobeKind::RandomWalk},
                                           {"RANDOM_WALK_LEGACY", LobeKind::RandomWalkLegacy},
                                           {"RANDOM_WALK_SKIN", LobeKind::RandomWalkSkin},
                                           {"BURLEY", LobeKind::Burley}});
}

NodeType subsurface_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 0.8f),
                                    number_input("Scale", 0.05f),
                                    {"Radius", SocketType::Vector, NodeValue(1.0f, 0.2f, 0.1f)},
                                    number_input("IOR", 1.4f),
                                    number_input("Roughness", 1.0f),
                                    number_input("Anisotropy", 0.0f),
                                    normal_input("Normal")});
    static constexpr auto outputs = std::to_array<OutputSocket>({{"BSSRDF", SocketType::Shader}});
    static constexpr auto options = std::to_array<std::string_view>({"falloff", "always_walks"});
    return closure_type<SubsurfaceNode>("SUBSURFACE_SCATTERING", inputs, outputs, options);
}

}  // namespace eye_render
