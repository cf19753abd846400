// Closures without a surface: light that shines, that passes straight through, or that is cut out
// of the picture.

#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/participating_medium.h"

namespace eye_render {

namespace {

// Of either sign, and small enough for products of a few to stay finite; 0 for NaN.
float signed_range(float value)
{
    return value < 0.0f ? -positive_range(-value) : positive_range(value);
}

Color3f signed_range(const Color3f& c)
{
    return {signed_range(c.x), signed_range(c.y), signed_range(c.z)};
}

bool is_constantly_dark(ConstantInputs constants, std::size_t input)
{
    const std::optional<NodeValue>& value = constants[input];
    return value && value->x == 0.0f && value->y == 0.0f && value->z == 0.0f;
}

// Of a material or a lamp; the world's is called Background.
class EmissionNode : public ClosureNode {
public:
    enum Input : std::size_t { Color, Strength };

    explicit EmissionNode(const NodeOptions& /*options*/) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs constants) const override
    {
        return {.may_emit = !is_constantly_dark(constants, Color) &&
                            !is_constantly_dark(constants, Strength)};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        shaded.emission += emission(in) * weight;
    }

    void fill(const NodeInputs& in, float weight, ParticipatingMedium& medium) const override
    {
        medium.emission += positive_range(emission(in)) * weight;
    }

    // What is negative takes light away, as in Cycles.
    [[nodiscard]] Color3f emission(const NodeInputs& in) const override
    {
        const float strength = signed_range(in.number(Strength));
        return strength != 0.0f ? signed_range(in.color(Color)) * strength : Color3f(0.0f);
    }
};

class TransparentNode : public ClosureNode {
public:
    enum Input : std::size_t { Color };

    explicit TransparentNode(const NodeOptions& /*options*/) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs constants) const override
    {
        return {.may_be_transparent = !is_constantly_zero(constants, Color), .lobes = 1};
    }

    void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const override
    {
        const Color3f passing = straight_transmittance(in) * weight;
        shaded.bsdf.add(straight_lobe(passing), passing);
    }

    [[nodiscard]] Color3f straight_transmittance(const NodeInputs& in) const override
    {
        return positive_range(in.color(Color));
    }
};

class HoldoutNode : public ClosureNode {
public:
    explicit HoldoutNode(const NodeOptions& /*options*/) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override { return {}; }

    void shade(const NodeInputs& /*in*/, float weight, ShadedPoint& shaded) const override
    {
        shaded.holdout += weight;
    }
};

}  // namespace

NodeType emission_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 1.0f), number_input("Strength", 1.0f)});
    static constexpr auto outputs =
        std::to_array<OutputSocket>({{"Emission", SocketType::Shader}});
    return closure_type<EmissionNode>("EMISSION", inputs, outputs);
}

NodeType background_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 0.8f), number_input("Strength", 1.0f)});
    static constexpr auto outputs =
        std::to_array<OutputSocket>({{"Background", SocketType::Shader}});
    return closure_type<EmissionNode>("BACKGROUND", inputs, outputs);
}

NodeType transparent_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>({color_input("Color", 1.0f)});
    return closure_type<TransparentNode>("BSDF_TRANSPARENT", inputs);
}

NodeType holdout_node()
{
    static constexpr auto outputs = std::to_array<OutputSocket>({{"Holdout", SocketType::Shader}});
    return closure_type<HoldoutNode>("HOLDOUT", {}, outputs);
}

}  // namespace eye_render
