// What bends the normal: Normal Map, Bump, and the displacement that is shown as bump.

#include "shading/bump.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"

#include <array>
#include <cmath>

namespace eye_render {

namespace {

using enum SocketType;
using Made = std::unique_ptr<const ValueNode>;

// To the world: what moves, and what stands on a surface.
[[nodiscard]] V3f vector_to_world(const Hit& hit, const V3f& v)
{
    V3f world;
    hit.attributes.object().world_from_object.multDirMatrix(v, world);
    return world;
}

[[nodiscard]] V3f normal_to_world(const Hit& hit, const V3f& n)
{
    V3f world;
    hit.attributes.object().object_from_world.transposed().multDirMatrix(n, world);
    return world;
}

[[nodiscard]] V3f normal_to_object(const Hit& hit, const V3f& n)
{
    V3f own;
    hit.attributes.object().world_from_object.transposed().multDirMatrix(n, own);
    return unit_or(own, n);
}

// A UV layer's directions in the object's own space, where Blender lays its maps: the object may
// stretch them. Unit; the tangent is zero where the layer has none.
struct OwnFrame {
    V3f tangent{0.0f};
    V3f bitangent{0.0f};
    V3f normal{0.0f};

    // `normal_world` on the side that the frame shall have.
    OwnFrame(const Hit& hit, int uv_layer, const V3f& normal_world)
    {
        const TangentFrame frame = hit.attributes.tangent(uv_layer);
        if (frame.tangent.length2() == 0.0f) {
            return;
        }
        const ObjectFacts& object = hit.attributes.object();
        object.object_from_world.multDirMatrix(frame.tangent, tangent);
        tangent = unit_or(tangent, V3f(0.0f));
        normal = normal_to_object(hit, normal_world);
        const bool is_mirrored = object.world_from_object.determinant() < 0.0f;
        bitangent = unit_or(normal.cross(tangent), V3f(0.0f)) *
                    (is_mirrored ? -frame.bitangent_sign : frame.bitangent_sign);
    }
};

class NormalMapNode final : public ValueNode {
public:
    // The BLENDER spaces have Y and Z reversed, as Blender's old baker wrote them.
    enum class Space { Tangent, Object, World, BlenderObject, BlenderWorld };

    NormalMapNode(Space space, int uv_layer) : space_(space), uv_layer_(uv_layer) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float strength = std::max(in.number(0), 0.0f);
        const V3f map = in.color(1) * 2.0f - V3f(1.0f);
        out[0] = space_ == Space::Tangent ? from_tangent_space(in.hit(), map, strength)
                                          : from_fixed_space(in.hit(), map, strength);
    }

private:
    [[nodiscard]] V3f from_tangent_space(const Hit& hit, const V3f& map, float strength) const
    {
        // The map belongs to the mesh's own side, so it is applied before the turn to the viewer.
        const OwnFrame own(hit, uv_layer_, hit.attributes.smooth_normal());
        if (own.tangent.length2() == 0.0f) {
            return hit.point.ns;
        }
        const float turn = hit.point.backfacing ? -1.0f : 1.0f;
        const float z = 1.0f + (map.z - 1.0f) * std::min(strength, 1.0f);
        const V3f bent =
            own.tangent * (map.x * strength) + own.bitangent * (map.y * strength) + own.normal * z;
        return unit_or(normal_to_world(hit, bent) * turn, hit.point.ns);
    }

    [[nodiscard]] V3f from_fixed_space(const Hit& hit, const V3f& map, float strength) const
    {
        const bool is_reversed = space_ == Space::BlenderObject || space_ == Space::BlenderWorld;
        V3f normal = is_reversed ? V3f(map.x, -map.y, -map.z) : map;
        if (space_ == Space::Object || space_ == Space::BlenderObject) {
            normal = normal_to_world(hit, normal);
        }
        normal = unit_or(normal, hit.point.ns);
        if (hit.point.backfacing) {
            normal = -normal;
        }
        return unit_or(hit.point.ns + (normal - hit.point.ns) * strength, hit.point.ns);
    }

    Space space_;
    int uv_layer_;
};

class BumpNode final : public ValueNode {
public:
    explicit BumpNode(bool is_inverted) : is_inverted_(is_inverted) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f normal = in.vector(normal_input);
        const float strength = std::max(in.number(0), 0.0f);
        const float distance = in.number(1) * (is_inverted_ ? -1.0f : 1.0f);
        if (strength == 0.0f || distance == 0.0f) {
            out[0] = normal;
            return;
        }
        const Hit& hit = in.hit();
        const float width_px = std::max(in.number(filter_width_input), 0.0f);
        const auto offsets = bump_offsets(hit.point, hit.attributes.position_world(), width_px);
        const float height = in.number(height_input);
        V2f rise(0.0f);
        for (int i = 0; i < 2; ++i) {
            hit.attributes.moved(
                offsets[static_cast<std::size_t>(i)], [&](const HitAttributes& there) {
                    rise[i] = (in.number_at(height_input, there) - height) * distance;
                });
        }
        const V3f bumped = bumped_normal(normal, offsets, rise);
        out[0] = unit_or(normal + (bumped - normal) * strength, normal);
    }

private:
    static constexpr std::size_t filter_width_input = 2;
    static constexpr std::size_t height_input = 3;
    static constexpr std::size_t normal_input = 4;

    bool is_inverted_;
};

class DisplacementNode final : public ValueNode {
public:
    explicit DisplacementNode(bool in_object_space) : in_object_space_(in_object_space) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float height = (in.number(0) - in.number(1)) * in.number(2);
        V3f normal = in.vector(3);
        if (in_object_space_) {
            // Along the normal, by a length of the object's own space.
            normal = vector_to_world(in.hit(), normal_to_object(in.hit(), normal));
        }
        out[0] = normal * height;
    }

private:
    bool in_object_space_;
};

class VectorDisplacementNode final : public ValueNode {
public:
    enum class Space { Tangent, Object, World };

    explicit VectorDisplacementNode(Space space) : space_(space) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f offset = (in.vector(0) - V3f(in.number(1))) * in.number(2);
        const Hit& hit = in.hit();
        switch (space_) {
        case Space::World: out[0] = offset; return;
        case Space::Object: out[0] = vector_to_world(hit, offset); return;
        case Space::Tangent: break;
        }
        const OwnFrame own(hit, HitAttributes::active_uv_layer, hit.point.ns);
        out[0] = vector_to_world(hit, own.tangent * offset.x + own.normal * offset.y +
                                          own.bitangent * offset.z);
    }

private:
    Space space_;
};

Made make_normal_map(const NodeOptions& options, NodeResources& resources)
{
    using Space = NormalMapNode::Space;
    return std::make_unique<NormalMapNode>(
        options.choice<Space>("space", {{"TANGENT", Space::Tangent},
                                        {"OBJECT", Space::Object},
                                        {"WORLD", Space::World},
                                        {"BLENDER_OBJECT", Space::BlenderObject},
                                        {"BLENDER_WORLD", Space::BlenderWorld}}),
        resources.uv_layer(options.text("uv_map", "")));
}

Made make_bump(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<BumpNode>(options.is_set("invert", false));
}

Made make_displacement(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<DisplacementNode>(
        options.choice<bool>("space", {{"OBJECT", true}, {"WORLD", false}}));
}

Made make_vector_displacement(const NodeOptions& options, NodeResources& resources)
{
    using Space = VectorDisplacementNode::Space;
    static_cast<void>(resources.uv_layer(""));  // what the tangent space is laid out by
    return std::make_unique<VectorDisplacementNode>(options.choice<Space>(
        "space",
        {{"TANGENT", Space::Tangent}, {"OBJECT", Space::Object}, {"WORLD", Space::World}}));
}

constexpr std::array normal_map_in{InputSocket{"Strength", Number, NodeValue(1.0f)},
                                   InputSocket{"Color", Color, NodeValue(0.5f, 0.5f, 1.0f)}};
constexpr std::array normal_out{OutputSocket{"Normal", Vector}};
constexpr std::array<std::string_view, 2> normal_map_options{"space", "uv_map"};
constexpr std::array bump_in{
    InputSocket{"Strength", Number, NodeValue(1.0f)},
    InputSocket{"Distance", Number, NodeValue(1.0f)},
    InputSocket{"Filter Width", Number, NodeValue(1.0f)},  // before Blender had it
    InputSocket{"Height", Number, NodeValue(1.0f)},
    InputSocket{"Normal", Vector, NodeValue(0.0f), ImplicitInput::Normal}};
constexpr std::array<std::string_view, 1> bump_options{"invert"};
constexpr std::array displacement_in{
    InputSocket{"Height", Number}, InputSocket{"Midlevel", Number, NodeValue(0.5f)},
    InputSocket{"Scale", Number, NodeValue(1.0f)},
    InputSocket{"Normal", Vector, NodeValue(0.0f), ImplicitInput::Normal}};
constexpr std::array displacement_out{OutputSocket{"Displacement", Vector}};
constexpr std::array<std::string_view, 1> displacement_options{"space"};
constexpr std::array vector_displacement_in{InputSocket{"Vector", Color, NodeValue(0.8f)},
                                            InputSocket{"Midlevel", Number},
                                            InputSocket{"Scale", Number, NodeValue(1.0f)}};

}  // namespace

std::span<const NodeType> normal_nodes()
{
    static const std::array nodes{
        hit_reader("NORMAL_MAP", normal_map_in, normal_out, make_normal_map, normal_map_options),
        hit_reader("BUMP", bump_in, normal_out, make_bump, bump_options),
        hit_reader("DISPLACEMENT", displacement_in, displacement_out, make_displacement,
                   displacement_options),
        hit_reader("VECTOR_DISPLACEMENT", vector_displacement_in, displacement_out,
                   make_vector_displacement, displacement_options),
    };
    return nodes;
}

}  // namespace eye_render
