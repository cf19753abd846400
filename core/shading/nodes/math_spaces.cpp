// Vector Transform: a point, a direction or a normal in the coordinates of the world, of the
// object that was hit, or of the camera (right, up, ahead).

#include "shading/functions/vector_operations.h"
#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/make_node.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

enum class Space { World, Object, Camera };
enum class Carried { Point, Vector, Normal };

// A change of coordinates, row vectors: p' = p * forward.
struct Change {
    M44f forward;
    M44f back;
};

[[nodiscard]] V3f carry(Carried what, const V3f& v, const Change& change)
{
    switch (what) {
    case Carried::Point: return v * change.forward;
    case Carried::Normal: {
        // The inverse's transpose.
        V3f normal;
        change.back.transposed().multDirMatrix(v, normal);
        return safe_normalized(normal);
    }
    default: {
        V3f direction;
        change.forward.multDirMatrix(v, direction);
        return direction;
    }
    }
}

// Nodes' camera coordinates look along +Z.
[[nodiscard]] M44f node_camera_from_world(const ViewFrame& view)
{
    M44f ahead;
    ahead[2][2] = -1.0f;
    return view.camera_from_world * ahead;
}

// Between the world and `space`.
[[nodiscard]] Change from_world(Space space, const HitAttributes& attributes)
{
    if (space == Space::Object) {
        const ObjectFacts& object = attributes.object();
        return {object.object_from_world, object.world_from_object};
    }
    const M44f camera_from_world = node_camera_from_world(attributes.view());
    return {camera_from_world, camera_from_world.inverse()};
}

[[nodiscard]] Space space_option(const NodeOptions& options, const char* name)
{
    return options.choice<Space>(
        name, {{"WORLD", Space::World}, {"OBJECT", Space::Object}, {"CAMERA", Space::Camera}});
}

class VectorTransformNode final : public ValueNode {
public:
    explicit VectorTransformNode(const NodeOptions& options)
        : carried_(options.choice<Carried>("vector_type",
                                           {{"VECTOR", Carried::Vector},
                                            {"POINT", Carried::Point},
                                            {"NORMAL", Carried::Normal}})),
          from_(space_option(options, "convert_from")), to_(space_option(options, "convert_to"))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const HitAttributes& attributes = in.hit().attributes;
        V3f v = in.vector(0);
        if (from_ != to_ && from_ != Space::World) {
            const Change change = from_world(from_, attributes);
            v = carry(carried_, v, {change.back, change.forward});
        }
        if (from_ != to_ && to_ != Space::World) {
            v = carry(carried_, v, from_world(to_, attributes));
        }
        out[0] = v;
    }

private:
    Carried carried_;
    Space from_;
    Space to_;
};

constexpr std::array transform_in{vector_input("Vector", NodeValue(0.5f))};
constexpr std::array vector_out{OutputSocket{"Vector", Vector}};
constexpr std::array<std::string_view, 3> transform_options{"vector_type", "convert_from",
                                                            "convert_to"};

}  // namespace

NodeType vector_transform_node()
{
    return value_node("VECT_TRANSFORM", Reads::Hit, transform_in, vector_out,
                      make_from_options<VectorTransformNode>, transform_options);
}

}  // namespace eye_render
