// The rows of math_nodes.cpp and color_nodes.cpp, by family.

#pragma once

#include "shading/nodes/make_node.h"
#include "shading/nodes/sockets.h"

namespace eye_render {

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

}  // namespace eye_render
