// Places and directions of the hit, in the coordinates that textures are laid out in.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/own_frame.h"
#include "shading/view_coordinates.h"

#include <Imath/ImathMatrixAlgo.h>

#include <array>
#include <cmath>
#include <optional>

namespace eye_render {

namespace {

using enum SocketType;

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
        const std::optional<StrandFacts> strand = hit.attributes.strand();
        out[2] = strand ? strand->tangent
                        : radial_tangent(hit, {-(generated.y - 0.5f), generated.x - 0.5f, 0.0f});
    }
    out[3] = hit.point.ng;
    out[4] = hit.point.wo;
    // Weights of the first two corners: Cycles' choice.
    const V2f parametric = hit.attributes.parametric();
    out[5] = {1.0f - parametric.x - parametric.y, parametric.x, 0.0f};
    out[6] = NodeValue(hit.point.backfacing ? 1.0f : 0.0f);
}

class TangentNode final : public ValueNode {
public:
    enum class Axis { X, Y, Z };

    // Around the axis, unless along a UV layer.
    TangentNode(const std::optional<TangentSource>& layer, Axis axis) : layer_(layer), axis_(axis)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Hit& hit = in.hit();
        if (layer_) {
            // As Cycles has it: brought to the world as a normal is, where an object is stretched.
            const V3f own = own_tangent(hit, *layer_).tangent;
            out[0] = turned_into(hit.point.ns, normal_to_world(hit.attributes.object(), own));
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
    std::optional<TangentSource> layer_;
    Axis axis_;
};

using Made = std::unique_ptr<const ValueNode>;

Made make_texture_coordinate(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<TextureCoordinateNode>(options.numbers("object_from_world"));
}

Made make_tangent(const NodeOptions& options, NodeResources& resources)
{
    const bool is_radial =
        options.choice<bool>("direction_type", {{"RADIAL", true}, {"UV_MAP", false}});
    std::optional<TangentSource> layer;
    if (!is_radial) {
        layer.emplace(options.text("uv_map", ""), resources);
    }
    return std::make_unique<TangentNode>(
        layer, options.choice<TangentNode::Axis>("axis", {{"Z", TangentNode::Axis::Z},
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
constexpr std::array tangent_out{OutputSocket{"Tangent", Vector}};
constexpr std::array<std::string_view, 3> tangent_options{"direction_type", "axis", "uv_map"};

}  // namespace

std::span<const NodeType> coordinate_nodes()
{
    static const std::array nodes{
        value_node("TEX_COORD", Reads::Hit, {}, texture_coordinate_out, make_texture_coordinate,
                   texture_coordinate_options),
        value_node("NEW_GEOMETRY", Reads::Hit, {}, geometry_out, make_function_node<geometry>),
        value_node("TANGENT", Reads::Hit, {}, tangent_out, make_tangent, tangent_options),
    };
    return nodes;
}

}  // namespace eye_render
