// Layers of the mesh and properties of the object, by name.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;
using Made = std::unique_ptr<const ValueNode>;

class UvMapNode final : public ValueNode {
public:
    explicit UvMapNode(int layer) : layer_(layer) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V2f uv = in.hit().attributes.uv(layer_);
        out[0] = {uv.x, uv.y, 0.0f};
    }

private:
    int layer_;
};

// Color, Vector, Fac and Alpha of a named attribute; of VERTEX_COLOR, Color and Alpha.
class AttributeNode final : public ValueNode {
public:
    AttributeNode(int attribute, bool is_color) : attribute_(attribute), is_color_(is_color) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const AttributeValue found = in.hit().attributes.attribute(attribute_);
        const Color4f& c = found.value;
        const V3f rgb(c.r, c.g, c.b);
        out[0] = rgb;
        if (is_color_) {
            out[1] = NodeValue(c.a);
            return;
        }
        out[1] = rgb;
        out[2] = NodeValue((c.r + c.g + c.b) / 3.0f);
        // What does not exist is opaque here, as in Cycles.
        out[3] = NodeValue(found.exists ? c.a : 1.0f);
    }

private:
    int attribute_;
    bool is_color_;
};

Made make_uv_map(const NodeOptions& options, NodeResources& resources)
{
    return std::make_unique<UvMapNode>(resources.uv_layer(options.text("uv_map", "")));
}

Made make_attribute(const NodeOptions& options, NodeResources& resources)
{
    return std::make_unique<AttributeNode>(resources.attribute(options.text("attribute_name", "")),
                                           false);
}

Made make_vertex_color(const NodeOptions& options, NodeResources& resources)
{
    return std::make_unique<AttributeNode>(resources.attribute(options.text("layer_name", "")),
                                           true);
}

constexpr std::array uv_map_out{OutputSocket{"UV", Vector}};
constexpr std::array<std::string_view, 1> uv_map_options{"uv_map"};
constexpr std::array attribute_out{OutputSocket{"Color", Color}, OutputSocket{"Vector", Vector},
                                   OutputSocket{"Fac", Number}, OutputSocket{"Alpha", Number}};
constexpr std::array<std::string_view, 1> attribute_options{"attribute_name"};
constexpr std::array vertex_color_out{OutputSocket{"Color", Color}, OutputSocket{"Alpha", Number}};
constexpr std::array<std::string_view, 1> vertex_color_options{"layer_name"};

}  // namespace

std::span<const NodeType> layer_nodes()
{
    static const std::array nodes{
        value_node("UVMAP", Reads::Hit, {}, uv_map_out, make_uv_map, uv_map_options),
        value_node("ATTRIBUTE", Reads::Hit, {}, attribute_out, make_attribute, attribute_options),
        value_node("VERTEX_COLOR", Reads::Hit, {}, vertex_color_out, make_vertex_color,
                   vertex_color_options),
    };
    return nodes;
}

}  // namespace eye_render
