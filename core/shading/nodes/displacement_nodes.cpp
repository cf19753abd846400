// What moves a surface, and is shown as bump: Displacement and Vector Displacement.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/own_frame.h"
#include "shading/nodes/sockets.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;
using Made = std::unique_ptr<const ValueNode>;

class DisplacementNode final : public ValueNode {
public:
    explicit DisplacementNode(bool in_object_space) : in_object_space_(in_object_space) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float height = (in.number(0) - in.number(1)) * in.number(2);
        V3f normal = in.vector(3);
        if (in_object_space_) {
            // Along the normal, by a length of the object's own space.
            const ObjectFacts& object = in.hit().attributes.object();
            normal = vector_to_world(object, unit_or(normal_to_object(object, normal), normal));
        }
        out[0] = normal * height;
    }

private:
    bool in_object_space_;
};

class VectorDisplacementNode final : public ValueNode {
public:
    enum class Space { Tangent, Object, World };

    VectorDisplacementNode(Space space, const TangentSource& tangents)
        : space_(space), tangents_(tangents)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f offset = (in.vector(0) - V3f(in.number(1))) * in.number(2);
        const Hit& hit = in.hit();
        switch (space_) {
        case Space::World: out[0] = offset; return;
        case Space::Object: out[0] = vector_to_world(hit.attributes.object(), offset); return;
        case Space::Tangent: break;
        }
        const OwnFrame own(hit, tangents_, hit.point.ns);
        out[0] = vector_to_world(hit.attributes.object(), own.tangent * offset.x +
                                                              own.normal * offset.y +
                                                              own.bitangent * offset.z);
    }

private:
    Space space_;
    TangentSource tangents_;
};

Made make_displacement(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<DisplacementNode>(
        options.choice<bool>("space", {{"OBJECT", true}, {"WORLD", false}}));
}

Made make_vector_displacement(const NodeOptions& options, NodeResources& resources)
{
    using Space = VectorDisplacementNode::Space;
    const auto space = options.choice<Space>(
        "space",
        {{"TANGENT", Space::Tangent}, {"OBJECT", Space::Object}, {"WORLD", Space::World}});
    return std::make_unique<VectorDisplacementNode>(
        space, space == Space::Tangent ? TangentSource("", resources) : TangentSource());
}

constexpr std::array displacement_in{number_input("Height"), number_input("Midlevel", 0.5f),
                                     number_input("Scale", 1.0f), normal_input()};
constexpr std::array displacement_out{OutputSocket{"Displacement", Vector}};
constexpr std::array<std::string_view, 1> displacement_options{"space"};
constexpr std::array vector_displacement_in{color_input("Vector", 0.8f), number_input("Midlevel"),
                                            number_input("Scale", 1.0f)};

}  // namespace

std::span<const NodeType> displacement_nodes()
{
    static const std::array nodes{
        value_node("DISPLACEMENT", Reads::Hit, displacement_in, displacement_out,
                   make_displacement, displacement_options),
        value_node("VECTOR_DISPLACEMENT", Reads::Hit, vector_displacement_in, displacement_out,
                   make_vector_displacement, displacement_options),
    };
    return nodes;
}

}  // namespace eye_render
