// Nodes of vectors: Vector Math, Mapping, Vector Rotate, Normal, Combine and Separate XYZ.

#include "shading/functions/rotation.h"
#include "shading/functions/vector_operations.h"
#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/vector_option.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

class VectorMathNode final : public ValueNode {
public:
    explicit VectorMathNode(const NodeOptions& options)
        : operation_(vector_operation(options.text("operation", "ADD")))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f none(0.0f);
        const V3f result =
            operation_.apply({.a = in.vector(0),
                              .b = operation_.vectors > 1 ? in.vector(1) : none,
                              .c = operation_.vectors > 2 ? in.vector(2) : none,
                              .scale = operation_.reads_scale ? in.number(3) : 0.0f});
        out[0] = operation_.is_number ? none : result;
        out[1] = operation_.is_number ? result : none;
    }

private:
    const VectorOperation& operation_;
};

class MappingNode final : public ValueNode {
public:
    explicit MappingNode(const NodeOptions& options)
        : kind_(options.choice<MappingKind>("vector_type",
                                            {{"POINT", MappingKind::Point},
                                             {"TEXTURE", MappingKind::Texture},
                                             {"VECTOR", MappingKind::Vector},
                                             {"NORMAL", MappingKind::Normal}}))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = mapped(
            kind_, in.vector(0),
            {.location = in.vector(1), .rotation_rad = in.vector(2), .scale = in.vector(3)});
    }

private:
    MappingKind kind_;
};

class VectorRotateNode final : public ValueNode {
public:
    explicit VectorRotateNode(const NodeOptions& options)
        : kind_(options.choice<Kind>("rotation_type",
                                     {{"AXIS_ANGLE", Kind::AnyAxis},
                                      {"X_AXIS", Kind::X},
                                      {"Y_AXIS", Kind::Y},
                                      {"Z_AXIS", Kind::Z},
                                      {"EULER_XYZ", Kind::Euler}})),
          is_inverse_(options.is_set("invert", false))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f center = in.vector(1);
        const V3f arm = in.vector(0) - center;
        if (kind_ == Kind::Euler) {
            const EulerRotation rotation(in.vector(4));
            out[0] = center + (is_inverse_ ? rotation.turned_back(arm) : rotation.turned(arm));
            return;
        }
        const V3f axis = unit_axis(in);
        const float angle_rad = is_inverse_ ? -in.number(3) : in.number(3);
        // An axis of no length turns nothing.
        out[0] = axis == V3f(0.0f) ? in.vector(0) : center + turned_about(arm, axis, angle_rad);
    }

private:
    enum class Kind { AnyAxis, X, Y, Z, Euler };

    [[nodiscard]] V3f unit_axis(const NodeInputs& in) const
    {
        switch (kind_) {
        case Kind::X: return {1.0f, 0.0f, 0.0f};
        case Kind::Y: return {0.0f, 1.0f, 0.0f};
        case Kind::Z: return {0.0f, 0.0f, 1.0f};
        default: return safe_normalized(in.vector(2));
        }
    }

    Kind kind_;
    bool is_inverse_;
};

class NormalNode final : public ValueNode {
public:
    explicit NormalNode(const NodeOptions& options)
        : direction_(safe_normalized(vector_option(options, "value", V3f(0.0f, 0.0f, 1.0f))))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = direction_;
        if (in.wants(1)) {
            out[1] = NodeValue(direction_.dot(safe_normalized(in.vector(0))));
        }
    }

private:
    V3f direction_;
};

void combine_xyz(const NodeInputs& in, std::span<NodeValue> out)
{
    out[0] = {in.number(0), in.number(1), in.number(2)};
}

void separate_xyz(const NodeInputs& in, std::span<NodeValue> out)
{
    const V3f v = in.vector(0);
    for (int i = 0; i < 3; ++i) {
        out[static_cast<std::size_t>(i)] = NodeValue(v[i]);
    }
}

constexpr std::array vector_math_in{vector_input("Vector"), vector_input("Vector_001"),
                                    vector_input("Vector_002"), number_input("Scale", 1.0f)};
constexpr std::array vector_math_out{OutputSocket{"Vector", Vector},
                                     OutputSocket{"Value", Number}};
constexpr std::array<std::string_view, 1> vector_math_options{"operation"};

constexpr std::array mapping_in{vector_input("Vector"), vector_input("Location"),
                                vector_input("Rotation"), vector_input("Scale", NodeValue(1.0f))};
constexpr std::array vector_out{OutputSocket{"Vector", Vector}};
constexpr std::array<std::string_view, 1> mapping_options{"vector_type"};

constexpr std::array rotate_in{vector_input("Vector"), vector_input("Center"),
                               vector_input("Axis", NodeValue(0.0f, 0.0f, 1.0f)),
                               number_input("Angle"), vector_input("Rotation")};
constexpr std::array<std::string_view, 2> rotate_options{"rotation_type", "invert"};

constexpr std::array normal_in{vector_input("Normal", NodeValue(0.0f, 0.0f, 1.0f))};
constexpr std::array normal_out{OutputSocket{"Normal", Vector}, OutputSocket{"Dot", Number}};
constexpr std::array<std::string_view, 1> normal_options{"value"};

constexpr std::array xyz_in{number_input("X"), number_input("Y"), number_input("Z")};
constexpr std::array one_vector_in{vector_input("Vector")};
constexpr std::array xyz_out{OutputSocket{"X", Number}, OutputSocket{"Y", Number},
                             OutputSocket{"Z", Number}};

}  // namespace

NodeType vector_math_node()
{
    return value_node("VECT_MATH", Reads::InputsAlone, vector_math_in, vector_math_out,
                      make_from_options<VectorMathNode>, vector_math_options);
}

NodeType mapping_node()
{
    return value_node("MAPPING", Reads::InputsAlone, mapping_in, vector_out,
                      make_from_options<MappingNode>, mapping_options);
}

NodeType vector_rotate_node()
{
    return value_node("VECTOR_ROTATE", Reads::InputsAlone, rotate_in, vector_out,
                      make_from_options<VectorRotateNode>, rotate_options);
}

NodeType normal_node()
{
    return value_node("NORMAL", Reads::InputsAlone, normal_in, normal_out,
                      make_from_options<NormalNode>, normal_options);
}

NodeType combine_xyz_node()
{
    return value_node("COMBXYZ", Reads::InputsAlone, xyz_in, vector_out,
                      make_function_node<combine_xyz>);
}

NodeType separate_xyz_node()
{
    return value_node("SEPXYZ", Reads::InputsAlone, one_vector_in, xyz_out,
                      make_function_node<separate_xyz>);
}

}  // namespace eye_render
