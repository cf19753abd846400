// The rows of math_nodes.cpp and color_nodes.cpp, by family, and what their nodes share.

#pragma once

#include "shading/node.h"

#include <memory>

namespace eye_render {

[[nodiscard]] constexpr InputSocket number_socket(std::string_view identifier, float value = 0.0f)
{
    return {identifier, SocketType::Number, NodeValue(value)};
}

[[nodiscard]] constexpr InputSocket vector_socket(std::string_view identifier,
                                                  const NodeValue& value = NodeValue(0.0f))
{
    return {identifier, SocketType::Vector, value};
}

[[nodiscard]] constexpr InputSocket color_socket(std::string_view identifier, float value)
{
    return {identifier, SocketType::Color, NodeValue(value)};
}

// For NodeType::make_value: the node is made from its options.
template <typename Node>
[[nodiscard]] std::unique_ptr<const ValueNode> make_from_options(const NodeOptions& options,
                                                                 NodeResources& /*resources*/)
{
    return std::make_unique<Node>(options);
}

// A node that is a function of its inputs alone.
[[nodiscard]] inline NodeType converter(std::string_view name,
                                        std::span<const InputSocket> inputs,
                                        std::span<const OutputSocket> outputs,
                                        decltype(NodeType::make_value) make,
                                        std::span<const std::string_view> options = {})
{
    return {.name = name,
            .inputs = inputs,
            .outputs = outputs,
            .options = options,
            .make_value = make};
}

// Numbers.
[[nodiscard]] NodeType math_node();
[[nodiscard]] NodeType map_range_node();
[[nodiscard]] NodeType clamp_node();
[[nodiscard]] NodeType value_node();

// Vectors.
[[nodiscard]] NodeType vector_math_node();
[[nodiscard]] NodeType mapping_node();
[[nodiscard]] NodeType vector_rotate_node();
[[nodiscard]] NodeType vector_transform_node();
[[nodiscard]] NodeType normal_node();
[[nodiscard]] NodeType combine_xyz_node();
[[nodiscard]] NodeType separate_xyz_node();

// Colours from numbers and back.
[[nodiscard]] NodeType rgb_node();
[[nodiscard]] NodeType combine_color_node();
[[nodiscard]] NodeType separate_color_node();
[[nodiscard]] NodeType combine_rgb_node();
[[nodiscard]] NodeType separate_rgb_node();
[[nodiscard]] NodeType combine_hsv_node();
[[nodiscard]] NodeType separate_hsv_node();
[[nodiscard]] NodeType rgb_to_bw_node();
[[nodiscard]] NodeType blackbody_node();
[[nodiscard]] NodeType wavelength_node();

// Curves and ramps.
[[nodiscard]] NodeType float_curve_node();
[[nodiscard]] NodeType vector_curve_node();
[[nodiscard]] NodeType rgb_curve_node();
[[nodiscard]] NodeType color_ramp_node();

// Mixtures.
[[nodiscard]] NodeType mix_node();
[[nodiscard]] NodeType mix_rgb_node();

// Adjustments.
[[nodiscard]] NodeType hue_saturation_node();
[[nodiscard]] NodeType bright_contrast_node();
[[nodiscard]] NodeType gamma_node();
[[nodiscard]] NodeType invert_node();
[[nodiscard]] NodeType light_falloff_node();

}  // namespace eye_render
