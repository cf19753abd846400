// Hue/Saturation/Value, Brightness/Contrast, Gamma, Invert.

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

constexpr std::array hue_in{number_input("Hue", 0.5f), number_input("Saturation", 1.0f),
                            number_input("Value", 1.0f), number_input("Fac", 1.0f),
                            color_input("Color", 0.8f)};
constexpr std::array contrast_in{color_input("Color", 1.0f), number_input("Bright"),
                                 number_input("Contrast")};
constexpr std::array gamma_in{color_input("Color", 1.0f), number_input("Gamma", 1.0f)};
constexpr std::array invert_in{number_input("Fac", 1.0f), color_input("Color", 0.0f)};
constexpr std::array color_out{OutputSocket{"Color", Color}};
}  // namespace

NodeType hue_saturation_node()
{
    return value_node("HUE_SAT", Reads::InputsAlone, hue_in, color_out,
                      make_function_node<hue_saturation>);
}

NodeType bright_contrast_node()
{
    return value_node("BRIGHTCONTRAST", Reads::InputsAlone, contrast_in, color_out,
                      make_function_node<bright_contrast>);
}

NodeType gamma_node()
{
    return value_node("GAMMA", Reads::InputsAlone, gamma_in, color_out, make_function_node<gamma>);
}

NodeType invert_node()
{
    return value_node("INVERT", Reads::InputsAlone, invert_in, color_out,
                      make_function_node<invert_color>);
}

}  // namespace eye_render
