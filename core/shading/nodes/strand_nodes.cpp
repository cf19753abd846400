// What is read from a strand of hair or a ball of a point cloud.

#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"

#include <algorithm>
#include <array>

namespace eye_render {

namespace {

using enum SocketType;

// All zero on what is no strand.
void hair_info(const NodeInputs& in, std::span<NodeValue> out)
{
    const Hit& hit = in.hit();
    const std::optional<StrandFacts> strand = hit.attributes.strand();
    if (!strand) {
        std::ranges::fill(out, NodeValue(0.0f));
        return;
    }
    out[0] = NodeValue(1.0f);
    out[1] = NodeValue(strand->intercept);
    out[2] = NodeValue(strand->length);
    out[3] = NodeValue(strand->thickness);
    // Across the strand, towards the viewer.
    const V3f& along = strand->tangent;
    out[4] = unit_or(hit.point.wo - along * along.dot(hit.point.wo), hit.point.ns);
    out[5] = NodeValue(strand->random);
}

// All zero on what is no point.
void point_info(const NodeInputs& in, std::span<NodeValue> out)
{
    const PointFacts point = in.hit().attributes.point().value_or(PointFacts{});
    out[0] = point.position_world;
    out[1] = NodeValue(point.radius);
    out[2] = NodeValue(point.random);
}

constexpr std::array hair_info_out{
    OutputSocket{"Is Strand", Number},      OutputSocket{"Intercept", Number},
    OutputSocket{"Length", Number},         OutputSocket{"Thickness", Number},
    OutputSocket{"Tangent Normal", Vector}, OutputSocket{"Random", Number}};
constexpr std::array point_info_out{OutputSocket{"Position", Vector},
                                    OutputSocket{"Radius", Number},
                                    OutputSocket{"Random", Number}};

}  // namespace

std::span<const NodeType> strand_nodes()
{
    static const std::array nodes{
        value_node("HAIR_INFO", Reads::Hit, {}, hair_info_out, make_function_node<hair_info>),
        value_node("POINT_INFO", Reads::Hit, {}, point_info_out, make_function_node<point_info>),
    };
    return nodes;
}

}  // namespace eye_render
