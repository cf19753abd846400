// The converter and vector nodes.

#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/node_tables.h"

#include <array>

namespace eye_render {

std::span<const NodeType> math_nodes()
{
    static const std::array nodes{
        math_node(),          map_range_node(),      clamp_node(),         value_node(),
        vector_math_node(),   mapping_node(),        vector_rotate_node(), vector_transform_node(),
        normal_node(),        combine_xyz_node(),    separate_xyz_node(),  rgb_node(),
        combine_color_node(), separate_color_node(), combine_rgb_node(),   separate_rgb_node(),
        combine_hsv_node(),   separate_hsv_node(),   rgb_to_bw_node(),     blackbody_node(),
        wavelength_node(),    float_curve_node(),    vector_curve_node(),
    };
    return nodes;
}

}  // namespace eye_render
