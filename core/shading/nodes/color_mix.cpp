// Mix, of numbers, vectors or colours, and the Mix RGB node of older Blenders.

#include "shading/functions/color_adjust.h"
#include "shading/functions/color_blend.h"
#include "shading/nodes/converter_nodes.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

// Inputs of Mix.
enum MixInput : std::size_t {
    FactorNumber,
    FactorVector,
    ANumber,
    BNumber,
    AVector,
    BVector,
    AColor,
    BColor
};
// Outputs of Mix; of the others nothing is to be had.
enum MixOutput : std::size_t { ResultNumber, ResultVector, ResultColor };

// What a MIX node and a MIX_RGB node differ in.
struct BlendPlan {
    std::size_t factor = FactorNumber;
    std::size_t a = AColor;
    std::size_t b = BColor;
    std::size_t result = ResultColor;
    bool clamps_factor = true;
    bool clamps_result = false;
};

class BlendNode final : public ValueNode {
public:
    BlendNode(const ColorBlend& blend, const BlendPlan& plan) : blend_(blend), plan_(plan) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float factor = in.number(plan_.factor);
        const Color3f mixed = blend_.apply(plan_.clamps_factor ? clamp_to_unit(factor) : factor,
                                           in.color(plan_.a), in.color(plan_.b));
        std::ranges::fill(out, NodeValue(0.0f));
        out[plan_.result] = plan_.clamps_result ? clamp_to_unit(mixed) : mixed;
    }

private:
    const ColorBlend& blend_;
    BlendPlan plan_;
};

class MixNumberNode final : public ValueNode {
public:
    explicit MixNumberNode(bool clamps_factor) : clamps_factor_(clamps_factor) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float given = in.number(FactorNumber);
        const float factor = clamps_factor_ ? clamp_to_unit(given) : given;
        std::ranges::fill(out, NodeValue(0.0f));
        out[ResultNumber] =
            NodeValue(in.number(ANumber) * (1.0f - factor) + in.number(BNumber) * factor);
    }

private:
    bool clamps_factor_;
};

class MixVectorNode final : public ValueNode {
public:
    MixVectorNode(bool is_uniform, bool clamps_factor)
        : is_uniform_(is_uniform), clamps_factor_(clamps_factor)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f given = is_uniform_ ? V3f(in.number(FactorNumber)) : in.vector(FactorVector);
        const V3f factor = clamps_factor_ ? clamp_to_unit(given) : given;
        std::ranges::fill(out, NodeValue(0.0f));
        out[ResultVector] =
            in.vector(AVector) * (V3f(1.0f) - factor) + in.vector(BVector) * factor;
    }

private:
    bool is_uniform_;
    bool clamps_factor_;
};

[[nodiscard]] std::unique_ptr<const ValueNode> make_mix(const NodeOptions& options,
                                                        NodeResources& /*resources*/)
{
    enum class Mixed { Number, Vector, Color };
    const bool clamps_factor = options.is_set("clamp_factor", true);
    switch (options.choice<Mixed>(
        "data_type",
        {{"FLOAT", Mixed::Number}, {"VECTOR", Mixed::Vector}, {"RGBA", Mixed::Color}})) {
    case Mixed::Number: return std::make_unique<MixNumberNode>(clamps_factor);
    case Mixed::Vector:
        return std::make_unique<MixVectorNode>(
            options.choice<bool>("factor_mode", {{"UNIFORM", true}, {"NON_UNIFORM", false}}),
            clamps_factor);
    default:
        return std::make_unique<BlendNode>(
            color_blend(options.text("blend_type", "MIX")),
            BlendPlan{.clamps_factor = clamps_factor,
                      .clamps_result = options.is_set("clamp_result", false)});
    }
}

[[nodiscard]] std::unique_ptr<const ValueNode> make_mix_rgb(const NodeOptions& options,
                                                            NodeResources& /*resources*/)
{
    return std::make_unique<BlendNode>(
        color_blend(options.text("blend_type", "MIX")),
        BlendPlan{.factor = 0,
                  .a = 1,
                  .b = 2,
                  .result = 0,
                  .clamps_factor = true,
                  .clamps_result = options.is_set("use_clamp", false)});
}

constexpr std::array mix_in{number_input("Factor_Float", 0.5f),
                            vector_input("Factor_Vector", NodeValue(0.5f)),
                            number_input("A_Float"),
                            number_input("B_Float"),
                            vector_input("A_Vector"),
                            vector_input("B_Vector"),
                            color_input("A_Color", 0.5f),
                            color_input("B_Color", 0.5f)};
constexpr std::array mix_out{OutputSocket{"Result_Float", Number},
                             OutputSocket{"Result_Vector", Vector},
                             OutputSocket{"Result_Color", Color}};
constexpr std::array<std::string_view, 5> mix_options{"data_type", "factor_mode", "blend_type",
                                                      "clamp_factor", "clamp_result"};

constexpr std::array mix_rgb_in{number_input("Fac", 0.5f), color_input("Color1", 0.5f),
                                color_input("Color2", 0.5f)};
constexpr std::array color_out{OutputSocket{"Color", Color}};
constexpr std::array<std::string_view, 2> mix_rgb_options{"blend_type", "use_clamp"};

}  // namespace

NodeType mix_node()
{
    return value_node("MIX", Reads::InputsAlone, mix_in, mix_out, make_mix, mix_options);
}

NodeType mix_rgb_node()
{
    return value_node("MIX_RGB", Reads::InputsAlone, mix_rgb_in, color_out, make_mix_rgb,
                      mix_rgb_options);
}

}  // namespace eye_render
