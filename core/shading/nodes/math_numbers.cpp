// Nodes of numbers: Math, Map Range, Clamp, Value.

#include "shading/functions/map_range.h"
#include "shading/functions/math_operations.h"
#include "shading/functions/safe_math.h"
#include "shading/nodes/converter_nodes.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

class MathNode final : public ValueNode {
public:
    explicit MathNode(const NodeOptions& options)
        : operation_(math_operation(options.text("operation", "ADD"))),
          is_clamped_(options.is_set("use_clamp", false))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float result =
            operation_.apply(in.number(0), operation_.operands > 1 ? in.number(1) : 0.0f,
                             operation_.operands > 2 ? in.number(2) : 0.0f);
        out[0] = NodeValue(is_clamped_ ? clamp_to_unit(result) : result);
    }

private:
    const MathOperation& operation_;
    bool is_clamped_;
};

class MapRangeNode final : public ValueNode {
public:
    explicit MapRangeNode(const NodeOptions& options)
        : is_vector_(
              options.choice<bool>("data_type", {{"FLOAT", false}, {"FLOAT_VECTOR", true}})),
          interpolation_(options.choice<RangeInterpolation>(
              "interpolation_type",
              {{"LINEAR", RangeInterpolation::Linear},
               {"STEPPED", RangeInterpolation::Stepped},
               {"SMOOTHSTEP", RangeInterpolation::Smoothstep},
               {"SMOOTHERSTEP", RangeInterpolation::Smootherstep}})),
          is_clamped_(options.is_set("clamp", true))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = NodeValue(is_vector_ ? 0.0f : number(in));
        out[1] = is_vector_ ? vector(in) : V3f(0.0f);
    }

private:
    static constexpr std::size_t first_vector = 6;

    [[nodiscard]] bool has_steps() const { return interpolation_ == RangeInterpolation::Stepped; }

    [[nodiscard]] float number(const NodeInputs& in) const
    {
        const RangeMap map{.from_min = in.number(1),
                           .from_max = in.number(2),
                           .to_min = in.number(3),
                           .to_max = in.number(4),
                           .steps = has_steps() ? in.number(5) : 0.0f};
        return clamped(map_range(interpolation_, in.number(0), map), map);
    }

    [[nodiscard]] V3f vector(const NodeInputs& in) const
    {
        const V3f x = in.vector(first_vector);
        const V3f from_min = in.vector(first_vector + 1);
        const V3f from_max = in.vector(first_vector + 2);
        const V3f to_min = in.vector(first_vector + 3);
        const V3f to_max = in.vector(first_vector + 4);
        const V3f steps = has_steps() ? in.vector(first_vector + 5) : V3f(0.0f);
        V3f y;
        for (int i = 0; i < 3; ++i) {
            const RangeMap map{.from_min = from_min[i],
                               .from_max = from_max[i],
                               .to_min = to_min[i],
                               .to_max = to_max[i],
                               .steps = steps[i]};
            y[i] = clamped(map_range_component(interpolation_, x[i], map), map);
        }
        return y;
    }

    [[nodiscard]] float clamped(float y, const RangeMap& map) const
    {
        return is_clamped_ ? clamp_to_range(y, map) : y;
    }

    bool is_vector_;
    RangeInterpolation interpolation_;
    bool is_clamped_;
};

class ClampNode final : public ValueNode {
public:
    explicit ClampNode(const NodeOptions& options)
        : orders_limits_(options.choice<bool>("clamp_type", {{"MINMAX", false}, {"RANGE", true}}))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float minimum = in.number(1);
        const float maximum = in.number(2);
        out[0] = NodeValue(orders_limits_ && minimum > maximum
                               ? clamp_between(in.number(0), maximum, minimum)
                               : clamp_between(in.number(0), minimum, maximum));
    }

private:
    bool orders_limits_;
};

class ConstantNumberNode final : public ValueNode {
public:
    explicit ConstantNumberNode(const NodeOptions& options)
        : value_(static_cast<float>(options.number("value", 0.5)))
    {
    }

    void evaluate(const NodeInputs& /*in*/, std::span<NodeValue> out) const override
    {
        out[0] = NodeValue(value_);
    }

private:
    float value_;
};

constexpr std::array math_in{number_input("Value", 0.5f), number_input("Value_001", 0.5f),
                             number_input("Value_002", 0.5f)};
constexpr std::array value_out{OutputSocket{"Value", Number}};
constexpr std::array<std::string_view, 2> math_options{"operation", "use_clamp"};

constexpr std::array map_range_in{number_input("Value", 1.0f),
                                  number_input("From Min"),
                                  number_input("From Max", 1.0f),
                                  number_input("To Min"),
                                  number_input("To Max", 1.0f),
                                  number_input("Steps", 4.0f),
                                  vector_input("Vector"),
                                  vector_input("From_Min_FLOAT3"),
                                  vector_input("From_Max_FLOAT3", NodeValue(1.0f)),
                                  vector_input("To_Min_FLOAT3"),
                                  vector_input("To_Max_FLOAT3", NodeValue(1.0f)),
                                  vector_input("Steps_FLOAT3", NodeValue(4.0f))};
constexpr std::array map_range_out{OutputSocket{"Result", Number}, OutputSocket{"Vector", Vector}};
constexpr std::array<std::string_view, 3> map_range_options{"data_type", "interpolation_type",
                                                            "clamp"};

constexpr std::array clamp_in{number_input("Value", 1.0f), number_input("Min"),
                              number_input("Max", 1.0f)};
constexpr std::array result_out{OutputSocket{"Result", Number}};
constexpr std::array<std::string_view, 1> clamp_options{"clamp_type"};

constexpr std::array<std::string_view, 1> constant_options{"value"};

}  // namespace

NodeType math_node()
{
    return value_node("MATH", Reads::InputsAlone, math_in, value_out, make_from_options<MathNode>,
                      math_options);
}

NodeType map_range_node()
{
    return value_node("MAP_RANGE", Reads::InputsAlone, map_range_in, map_range_out,
                      make_from_options<MapRangeNode>, map_range_options);
}

NodeType clamp_node()
{
    return value_node("CLAMP", Reads::InputsAlone, clamp_in, result_out,
                      make_from_options<ClampNode>, clamp_options);
}

NodeType value_node()
{
    return value_node("VALUE", Reads::InputsAlone, {}, value_out,
                      make_from_options<ConstantNumberNode>, constant_options);
}

}  // namespace eye_render
