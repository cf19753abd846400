// Places of the hit in the coordinates that textures are laid out in, and layers of the mesh.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/view_coordinates.h"

#include <Imath/ImathMatrixAlgo.h>

#include <array>
#include <cmath>

namespace eye_render {

namespace {

using enum SocketType;

// A normal from object space to the world and back: by the inverse transpose.
[[nodiscard]] V3f normal_to_world(const ObjectFacts& object, const V3f& n)
{
    V3f result;
    object.object_from_world.transposed().multDirMatrix(n, result);
    return result;
}

[[nodiscard]] V3f normal_to_object(const ObjectFacts& object, const V3f& n)
{
    V3f result;
    object.world_from_object.transposed().multDirMatrix(n, result);
    return result;
}

// The direction across the normal that is nearest to `v`, unit.
[[nodiscard]] V3f turned_into(const V3f& n, const V3f& v)
{
    return unit_or(n.cross(unit_or(v.cross(n), V3f(0.0f))), V3f(0.0f));
}

// Around an axis of the texture space, turned into the surface.
[[nodiscard]] V3f radial_tangent(const Hit& hit, const V3f& around)
{
    return turned_into(hit.point.ns, normal_to_world(hit.attributes.object(), around));
}

class TextureCoordinateNode final : public ValueNode {
public:
    // `object_from_world`, of another object whose coordinates are wanted: a matrix for column
    // vectors, by rows; empty without one.
    explicit TextureCoordinateNode(const std::vector<float>& object_from_world)
        : has_object_(!object_from_world.empty())
    {
        if (!has_object_) {
            return;
        }
        if (object_from_world.size() != 16) {
            throw std::invalid_argument("object_from_world has " +
                                        std::to_string(object_from_world.size()) +
                                        " numbers; expected 16");
        }
        auto entry = object_from_world.begin();
        for (int row = 0; row < 4; ++row) {
            for (int column = 0; column < 4; ++column) {
                object_from_world_[column][row] = *entry++;
            }
        }
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Hit& hit = in.hit();
        const HitAttributes& at = hit.attributes;
        if (in.wants(0)) {
            out[0] = at.generated();
        }
        if (in.wants(1)) {
            out[1] = unit_or(normal_to_object(at.object(), hit.point.ns), hit.point.ns);
        }
        if (in.wants(2)) {
            const V2f uv = at.uv(HitAttributes::active_uv_layer);
            out[2] = {uv.x, uv.y, 0.0f};
        }
        if (in.wants(3)) {
            out[3] = has_object_ ? at.position_world() * object_from_world_ : at.position_object();
        }
        if (in.wants(4)) {
            out[4] = view_position(at);
        }
        if (in.wants(5)) {
            out[5] = window_position(at);
        }
        if (in.wants(6)) {
            const V3f& n = hit.point.ns;
            out[6] = n * (2.0f * n.dot(hit.point.wo)) - hit.point.wo;
        }
    }

private:
    bool has_object_;
    M44f object_from_world_;
};

void geometry(const NodeInputs& in, std::span<NodeValue> out)
{
    const Hit& hit = in.hit();
    out[0] = hit.attributes.position_world();
    out[1] = hit.point.ns;
    if (in.wants(2)) {
        const V3f generated = hit.attributes.generated();
        out[2] = radial_tangent(hit, {-(generated.y - 0.5f), generated.x - 0.5f, 0.0f});
    }
    out[3] = hit.point.ng;
    out[4] = hit.point.wo;
    // Weights of the first two corners: Cycles' choice.
    const V2f parametric = hit.attributes.parametric();
    out[5] = {1.0f - parametric.x - parametric.y, parametric.x, 0.0f};
    out[6] = NodeValue(hit.point.backfacing ? 1.0f : 0.0f);
}

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

class TangentNode final : public ValueNode {
public:
    enum class Axis { X, Y, Z };
    static constexpr int radial = -1;

    TangentNode(int uv_layer, Axis axis) : uv_layer_(uv_layer), axis_(axis) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Hit& hit = in.hit();
        if (uv_layer_ != radial) {
            // As Cycles has it: brought to the world as a normal is, where an object is stretched.
            const ObjectFacts& object = hit.attributes.object();
            V3f own;
            object.object_from_world.multDirMatrix(hit.attributes.tangent(uv_layer_).tangent, own);
            out[0] = turned_into(hit.point.ns, normal_to_world(object, own));
            return;
        }
        const V3f from_middle = hit.attributes.generated() - V3f(0.5f);
        switch (axis_) {
        case Axis::X: out[0] = radial_tangent(hit, {0.0f, -from_middle.z, from_middle.y}); break;
        case Axis::Y: out[0] = radial_tangent(hit, {-from_middle.z, 0.0f, from_middle.x}); break;
        case Axis::Z: out[0] = radial_tangent(hit, {-from_middle.y, from_middle.x, 0.0f}); break;
        }
    }

private:
    int uv_layer_;
    Axis axis_;
};

using Made = std::unique_ptr<const ValueNode>;

Made make_texture_coordinate(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<TextureCoordinateNode>(options.numbers("object_from_world"));
}

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

Made make_tangent(const NodeOptions& options, NodeResources& resources)
{
    const bool is_radial =
        options.choice<bool>("direction_type", {{"RADIAL", true}, {"UV_MAP", false}});
    return std::make_unique<TangentNode>(
        is_radial ? TangentNode::radial : resources.uv_layer(options.text("uv_map", "")),
        options.choice<TangentNode::Axis>("axis", {{"Z", TangentNode::Axis::Z},
                                                   {"X", TangentNode::Axis::X},
                                                   {"Y", TangentNode::Axis::Y}}));
}

constexpr std::array texture_coordinate_out{
    OutputSocket{"Generated", Vector}, OutputSocket{"Normal", Vector},
    OutputSocket{"UV", Vector, true},  OutputSocket{"Object", Vector},
    OutputSocket{"Camera", Vector},    OutputSocket{"Window", Vector},
    OutputSocket{"Reflection", Vector}};
constexpr std::array<std::string_view, 1> texture_coordinate_options{"object_from_world"};
constexpr std::array geometry_out{
    OutputSocket{"Position", Vector},  OutputSocket{"Normal", Vector},
    OutputSocket{"Tangent", Vector},   OutputSocket{"True Normal", Vector},
    OutputSocket{"Incoming", Vector},  OutputSocket{"Parametric", Vector},
    OutputSocket{"Backfacing", Number}};
constexpr std::array uv_map_out{OutputSocket{"UV", Vector}};
constexpr std::array<std::string_view, 1> uv_map_options{"uv_map"};
constexpr std::array attribute_out{OutputSocket{"Color", Color}, OutputSocket{"Vector", Vector},
                                   OutputSocket{"Fac", Number}, OutputSocket{"Alpha", Number}};
constexpr std::array<std::string_view, 1> attribute_options{"attribute_name"};
constexpr std::array vertex_color_out{OutputSocket{"Color", Color}, OutputSocket{"Alpha", Number}};
constexpr std::array<std::string_view, 1> vertex_color_options{"layer_name"};
constexpr std::array tangent_out{OutputSocket{"Tangent", Vector}};
constexpr std::array<std::string_view, 3> tangent_options{"direction_type", "axis", "uv_map"};

}  // namespace

std::span<const NodeType> coordinate_nodes()
{
    static const std::array nodes{
        hit_reader("TEX_COORD", {}, texture_coordinate_out, make_texture_coordinate,
                   texture_coordinate_options),
        hit_reader("NEW_GEOMETRY", {}, geometry_out, make_function_node<geometry>),
        hit_reader("UVMAP", {}, uv_map_out, make_uv_map, uv_map_options),
        hit_reader("ATTRIBUTE", {}, attribute_out, make_attribute, attribute_options),
        hit_reader("VERTEX_COLOR", {}, vertex_color_out, make_vertex_color, vertex_color_options),
        hit_reader("TANGENT", {}, tangent_out, make_tangent, tangent_options),
    };
    return nodes;
}

}  // namespace eye_render
