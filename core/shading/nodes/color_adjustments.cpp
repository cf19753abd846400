// Hue/Saturation/Value, Brightness/Contrast, Gamma, Invert, and Light Falloff as surfaces see it.

#include "shading/functions/color_adjust.h"
#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/make_node.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

void hue_saturation(const NodeInputs& in, std::span<NodeValue> out)
{
    const HueSaturationValue by{
        .hue = in.number(0), .saturation = in.number(1), .value = in.number(2)};
    out[0] = adjust_hsv(in.color(4), by, in.number(3));
}

void bright_contrast(const NodeInputs& in, std::span<NodeValue> out)
{
    out[0] = adjust_contrast(in.color(0), in.number(1), in.number(2));
}

void gamma(const NodeInputs& in, std::span<NodeValue> out)
{
    out[0] = adjust_gamma(in.color(0), in.number(1));
}

void invert_color(const NodeInputs& in, std::span<NodeValue> out)
{
    out[0] = invert(in.color(1), in.number(0));
}

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

constexpr std::array hue_in{number_socket("Hue", 0.5f), number_socket("Saturation", 1.0f),
                            number_socket("Value", 1.0f), number_socket("Fac", 1.0f),
                            color_socket("Color", 0.8f)};
constexpr std::array contrast_in{color_socket("Color", 1.0f), number_socket("Bright"),
                                 number_socket("Contrast")};
constexpr std::array gamma_in{color_socket("Color", 1.0f), number_socket("Gamma", 1.0f)};
constexpr std::array invert_in{number_socket("Fac", 1.0f), color_socket("Color", 0.0f)};
constexpr std::array falloff_in{number_socket("Strength", 100.0f), number_socket("Smooth")};
constexpr std::array color_out{OutputSocket{"Color", Color}};
constexpr std::array falloff_out{OutputSocket{"Quadratic", Number}, OutputSocket{"Linear", Number},
                                 OutputSocket{"Constant", Number}};

}  // namespace

NodeType hue_saturation_node()
{
    return converter("HUE_SAT", hue_in, color_out, make_function_node<hue_saturation>);
}

NodeType bright_contrast_node()
{
    return converter("BRIGHTCONTRAST", contrast_in, color_out,
                     make_function_node<bright_contrast>);
}

NodeType gamma_node()
{
    return converter("GAMMA", gamma_in, color_out, make_function_node<gamma>);
}

NodeType invert_node()
{
    return converter("INVERT", invert_in, color_out, make_function_node<invert_color>);
}

NodeType light_falloff_node()
{
    return hit_reader("LIGHT_FALLOFF", falloff_in, falloff_out, make_function_node<light_falloff>);
}

}  // namespace eye_render
