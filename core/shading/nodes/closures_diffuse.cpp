// Closures that scatter widely.

#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/visible_normal.h"

namespace eye_render {

namespace {

class DiffuseNode : public ClosureNode {
public:
    enum Input : std::size_t { Color, Roughness, Normal };

    explicit DiffuseNode(const NodeOptions& /*options*/) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override
    {
        return {.lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const ShadingPoint& point = in.hit().point;
        const Color3f color = positive_range(in.color(Color)) * weight;
        shaded.bsdf.add(diffuse_lobe(color, unit_normal(in.vector(Normal), point.ns), point.ns),
                        color);
    }
};

}  // namespace

NodeType diffuse_node()
{
    static constexpr InputSocket inputs[] = {
        color_input("Color", 0.8f), number_input("Roughness", 0.0f), normal_input("Normal")};
    return closure_type<DiffuseNode>("BSDF_DIFFUSE", inputs);
}

}  // namespace eye_render
