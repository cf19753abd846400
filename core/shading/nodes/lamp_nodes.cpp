// What the light of lamps is dressed with: Light Falloff and IES Texture.

#include "shading/ies_profile.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/sockets.h"

#include <array>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

using enum SocketType;

// Light falls off with the distance squared by itself: the other outputs undo a part of that.
void light_falloff(const NodeInputs& in, std::span<NodeValue> out)
{
    const float length = in.hit().path.length;
    const float squared = length * length;
    const float smooth = in.number(1);
    // Far away there is nothing to smooth, and what comes from infinity has no finite square.
    const bool is_smoothed = smooth > 0.0f && std::isfinite(squared);
    const float strength = in.number(0) * (is_smoothed ? squared / (smooth + squared) : 1.0f);
    out[0] = NodeValue(strength);
    out[1] = NodeValue(strength * length);
    out[2] = NodeValue(strength * squared);
}

class IesNode final : public ValueNode {
public:
    explicit IesNode(const NodeOptions& options) : profile_(parse_ies(options.text("ies", ""))) {}

    // The vector points from the lamp to what it lights; the profile's axis is -Z.
    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const V3f d = unit_or(in.vector(0), V3f(0.0f, 0.0f, -1.0f));
        const float vertical_rad = std::acos(std::clamp(-d.z, -1.0f, 1.0f));
        const float horizontal_rad = std::atan2(d.x, d.y) + std::numbers::pi_v<float>;
        out[0] = NodeValue(in.number(1) * profile_.at(horizontal_rad, vertical_rad));
    }

private:
    IesProfile profile_;
};

constexpr std::array falloff_in{number_input("Strength", 100.0f), number_input("Smooth")};
constexpr std::array falloff_out{OutputSocket{"Quadratic", Number}, OutputSocket{"Linear", Number},
                                 OutputSocket{"Constant", Number}};

constexpr std::array ies_in{
    InputSocket{"Vector", Vector, NodeValue(0.0f), ImplicitInput::Incoming},
    number_input("Strength", 1.0f)};
constexpr std::array fac_out{OutputSocket{"Fac", Number}};
constexpr std::array<std::string_view, 1> ies_options{"ies"};

}  // namespace

std::span<const NodeType> lamp_nodes()
{
    static const std::array nodes{
        value_node("LIGHT_FALLOFF", Reads::Hit, falloff_in, falloff_out,
                   make_function_node<light_falloff>),
        value_node("TEX_IES", Reads::InputsAlone, ies_in, fac_out, make_from_options<IesNode>,
                   ies_options),
    };
    return nodes;
}

}  // namespace eye_render
