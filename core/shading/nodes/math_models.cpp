// Nodes between colours and numbers: Combine and Separate Color and their older forms, RGB, RGB to
// BW, Blackbody, Wavelength.

#include "shading/functions/color_models.h"
#include "shading/functions/spectral_colors.h"
#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/vector_option.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

enum class ColorModel { Rgb, Hsv, Hsl };

[[nodiscard]] Color3f rgb_from(ColorModel model, const V3f& parts)
{
    switch (model) {
    case ColorModel::Hsv: return rgb_from_hsv(parts);
    case ColorModel::Hsl: return rgb_from_hsl(parts);
    default: return parts;
    }
}

[[nodiscard]] V3f parts_from(ColorModel model, const Color3f& rgb)
{
    switch (model) {
    case ColorModel::Hsv: return hsv_from_rgb(rgb);
    case ColorModel::Hsl: return hsl_from_rgb(rgb);
    default: return rgb;
    }
}

[[nodiscard]] V3f three_numbers(const NodeInputs& in)
{
    return {in.number(0), in.number(1), in.number(2)};
}

void spread(const V3f& parts, std::span<NodeValue> out)
{
    for (int i = 0; i < 3; ++i) {
        out[static_cast<std::size_t>(i)] = NodeValue(parts[i]);
    }
}

[[nodiscard]] ColorModel model_option(const NodeOptions& options)
{
    return options.choice<ColorModel>(
        "mode", {{"RGB", ColorModel::Rgb}, {"HSV", ColorModel::Hsv}, {"HSL", ColorModel::Hsl}});
}

class CombineColorNode final : public ValueNode {
public:
    explicit CombineColorNode(const NodeOptions& options) : model_(model_option(options)) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = rgb_from(model_, three_numbers(in));
    }

private:
    ColorModel model_;
};

class SeparateColorNode final : public ValueNode {
public:
    explicit SeparateColorNode(const NodeOptions& options) : model_(model_option(options)) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        spread(parts_from(model_, in.color(0)), out);
    }

private:
    ColorModel model_;
};

class ConstantColorNode final : public ValueNode {
public:
    explicit ConstantColorNode(const NodeOptions& options)
        : value_(vector_option(options, "value", V3f(0.5f)))
    {
    }

    void evaluate(const NodeInputs& /*in*/, std::span<NodeValue> out) const override
    {
        out[0] = value_;
    }

private:
    Color3f value_;
};

// A node of older Blenders has one model.
template <ColorModel model>
void combine(const NodeInputs& in, std::span<NodeValue> out)
{
    out[0] = rgb_from(model, three_numbers(in));
}

template <ColorModel model>
void separate(const NodeInputs& in, std::span<NodeValue> out)
{
    spread(parts_from(model, in.color(0)), out);
}

[[nodiscard]] NodeValue grey(const NodeInputs& in, WorkingSpace space)
{
    return NodeValue(luminance_weights(space).dot(in.color(0)));
}

[[nodiscard]] NodeValue blackbody(const NodeInputs& in, WorkingSpace space)
{
    return rgb_of_blackbody(in.number(0), space);
}

[[nodiscard]] NodeValue wavelength(const NodeInputs& in, WorkingSpace space)
{
    return rgb_of_wavelength(in.number(0), space);
}

// A node whose one output depends on what the scene's colours are.
template <NodeValue (*function)(const NodeInputs&, WorkingSpace)>
class SpaceNode final : public ValueNode {
public:
    explicit SpaceNode(WorkingSpace space) : space_(space) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = function(in, space_);
    }

private:
    WorkingSpace space_;
};

template <NodeValue (*function)(const NodeInputs&, WorkingSpace)>
[[nodiscard]] std::unique_ptr<const ValueNode> make_space_node(const NodeOptions& /*options*/,
                                                               NodeResources& resources)
{
    return std::make_unique<SpaceNode<function>>(resources.working_space());
}

constexpr float default_grey = 0.8f;

constexpr std::array color_in{color_input("Color", default_grey)};
constexpr std::array grey_in{color_input("Color", 0.5f)};
constexpr std::array image_in{color_input("Image", default_grey)};
constexpr std::array parts_in{number_input("Red"), number_input("Green"), number_input("Blue")};
constexpr std::array rgb_in{number_input("R"), number_input("G"), number_input("B")};
constexpr std::array hsv_in{number_input("H"), number_input("S"), number_input("V")};
constexpr std::array kelvin_in{number_input("Temperature", 1500.0f)};
constexpr std::array wavelength_in{number_input("Wavelength", 500.0f)};

constexpr std::array color_out{OutputSocket{"Color", Color}};
constexpr std::array image_out{OutputSocket{"Image", Color}};
constexpr std::array value_out{OutputSocket{"Val", Number}};
constexpr std::array parts_out{OutputSocket{"Red", Number}, OutputSocket{"Green", Number},
                               OutputSocket{"Blue", Number}};
constexpr std::array rgb_out{OutputSocket{"R", Number}, OutputSocket{"G", Number},
                             OutputSocket{"B", Number}};
constexpr std::array hsv_out{OutputSocket{"H", Number}, OutputSocket{"S", Number},
                             OutputSocket{"V", Number}};

constexpr std::array<std::string_view, 1> mode_options{"mode"};
constexpr std::array<std::string_view, 1> value_options{"value"};

}  // namespace

NodeType rgb_node()
{
    return value_node("RGB", Reads::InputsAlone, {}, color_out,
                      make_from_options<ConstantColorNode>, value_options);
}

NodeType combine_color_node()
{
    return value_node("COMBINE_COLOR", Reads::InputsAlone, parts_in, color_out,
                      make_from_options<CombineColorNode>, mode_options);
}

NodeType separate_color_node()
{
    return value_node("SEPARATE_COLOR", Reads::InputsAlone, color_in, parts_out,
                      make_from_options<SeparateColorNode>, mode_options);
}

NodeType combine_rgb_node()
{
    return value_node("COMBRGB", Reads::InputsAlone, rgb_in, image_out,
                      make_function_node<combine<ColorModel::Rgb>>);
}

NodeType separate_rgb_node()
{
    return value_node("SEPRGB", Reads::InputsAlone, image_in, rgb_out,
                      make_function_node<separate<ColorModel::Rgb>>);
}

NodeType combine_hsv_node()
{
    return value_node("COMBHSV", Reads::InputsAlone, hsv_in, color_out,
                      make_function_node<combine<ColorModel::Hsv>>);
}

NodeType separate_hsv_node()
{
    return value_node("SEPHSV", Reads::InputsAlone, color_in, hsv_out,
                      make_function_node<separate<ColorModel::Hsv>>);
}

NodeType rgb_to_bw_node()
{
    return value_node("RGBTOBW", Reads::InputsAlone, grey_in, value_out, make_space_node<grey>);
}

NodeType blackbody_node()
{
    return value_node("BLACKBODY", Reads::InputsAlone, kelvin_in, color_out,
                      make_space_node<blackbody>);
}

NodeType wavelength_node()
{
    return value_node("WAVELENGTH", Reads::InputsAlone, wavelength_in, color_out,
                      make_space_node<wavelength>);
}

}  // namespace eye_render
