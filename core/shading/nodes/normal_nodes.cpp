// What bends the normal: Normal Map and Bump.

#include "shading/bump.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/own_frame.h"
#include "shading/nodes/sockets.h"

#include <array>
#include <cmath>
#include <functional>

namespace eye_render {

namespace {

using enum SocketType;
using Made = std::unique_ptr<const ValueNode>;

class NormalMapNode final : public ValueNode {
public:
    // The BLENDER spaces have Y and Z reversed, as Blender's old baker wrote them.
    enum class Space { Tangent, Object, World, BlenderObject, BlenderWorld };

    NormalMapNode(Space space, const TangentSource& tangents) : space_(space), tangents_(tangents)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float strength = in.number(0);
        const V3f map = in.color(1) * 2.0f - V3f(1.0f);
        out[0] = space_ == Space::Tangent
                     ? from_tangent_space(in.hit(), map, strength)
                     : from_fixed_space(in.hit(), map, std::max(strength, 0.0f));
    }

private:
    [[nodiscard]] V3f from_tangent_space(const Hit& hit, const V3f& map, float strength) const
    {
        // The map belongs to the mesh's own side, so it is applied before the turn to the viewer.
        const OwnFrame own(hit, tangents_, hit.attributes.smooth_normal());
        if (own.tangent.length2() == 0.0f) {
            return hit.point.ns;
        }
        const float turn = hit.point.backfacing ? -1.0f : 1.0f;
        // Below 0 it turns hollows into bumps, as in Cycles.
        const float z = 1.0f + (map.z - 1.0f) * std::clamp(strength, 0.0f, 1.0f);
        const V3f bent =
            own.tangent * (map.x * strength) + own.bitangent * (map.y * strength) + own.normal * z;
        return unit_or(normal_to_world(hit.attributes.object(), bent) * turn, hit.point.ns);
    }

    [[nodiscard]] V3f from_fixed_space(const Hit& hit, const V3f& map, float strength) const
    {
        const bool is_reversed = space_ == Space::BlenderObject || space_ == Space::BlenderWorld;
        V3f normal = is_reversed ? V3f(map.x, -map.y, -map.z) : map;
        if (space_ == Space::Object || space_ == Space::BlenderObject) {
            normal = normal_to_world(hit.attributes.object(), normal);
        }
        normal = unit_or(normal, hit.point.ns);
        if (hit.point.backfacing) {
            normal = -normal;
        }
        return unit_or(hit.point.ns + (normal - hit.point.ns) * strength, hit.point.ns);
    }

    Space space_;
    TangentSource tangents_;
};

class BumpNode final : public ValueNode {
public:
    explicit BumpNode(bool is_inverted) : is_inverted_(is_inverted) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f normal = in.vector(Normal);
        const float strength = std::max(in.number(Strength), 0.0f);
        const float distance = in.number(Distance) * (is_inverted_ ? -1.0f : 1.0f);
        if (strength == 0.0f || distance == 0.0f) {
            out[0] = normal;
            return;
        }
        const Hit& hit = in.hit();
        const float width_px = std::max(in.number(FilterWidth), 0.0f);
        const auto offsets = bump_offsets(hit.point, hit.attributes.position_world(), width_px);
        const float height = in.number(Height);
        V2f rise(0.0f);
        for (int i = 0; i < 2; ++i) {
            const auto look = [&](const HitAttributes& there) {
                rise[i] = (in.number_at(Height, there) - height) * distance;
            };
            // By reference: what it captures is more than std::function holds without the heap.
            hit.attributes.moved(offsets[static_cast<std::size_t>(i)], std::ref(look));
        }
        const V3f bumped = bumped_normal(normal, offsets, rise);
        out[0] = unit_or(normal + (bumped - normal) * strength, normal);
    }

private:
    enum Input : std::size_t { Strength, Distance, FilterWidth, Height, Normal };

    bool is_inverted_;
};

Made make_normal_map(const NodeOptions& options, NodeResources& resources)
{
    using Space = NormalMapNode::Space;
    const auto space = options.choice<Space>("space", {{"TANGENT", Space::Tangent},
                                                       {"OBJECT", Space::Object},
                                                       {"WORLD", Space::World},
                                                       {"BLENDER_OBJECT", Space::BlenderObject},
                                                       {"BLENDER_WORLD", Space::BlenderWorld}});
    return std::make_unique<NormalMapNode>(
        space, space == Space::Tangent ? TangentSource(options.text("uv_map", ""), resources)
                                       : TangentSource());
}

Made make_bump(const NodeOptions& options, NodeResources& /*resources*/)
{
    return std::make_unique<BumpNode>(options.is_set("invert", false));
}

constexpr std::array normal_map_in{number_input("Strength", 1.0f),
                                   InputSocket{"Color", Color, NodeValue(0.5f, 0.5f, 1.0f)}};
constexpr std::array normal_out{OutputSocket{"Normal", Vector}};
constexpr std::array<std::string_view, 2> normal_map_options{"space", "uv_map"};
constexpr std::array bump_in{
    number_input("Strength", 1.0f), number_input("Distance", 1.0f),
    number_input("Filter Width", 1.0f),  // pixels; fixed before Blender 4.4
    number_input("Height", 1.0f), normal_input()};
constexpr std::array<std::string_view, 1> bump_options{"invert"};

}  // namespace

std::span<const NodeType> normal_nodes()
{
    static const std::array nodes{
        value_node("NORMAL_MAP", Reads::Hit, normal_map_in, normal_out, make_normal_map,
                   normal_map_options),
        value_node("BUMP", Reads::Hit, bump_in, normal_out, make_bump, bump_options),
    };
    return nodes;
}

}  // namespace eye_render
