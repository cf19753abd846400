// The colour nodes.

#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/node_tables.h"

#include <array>

namespace eye_render {

std::span<const NodeType> color_nodes()
{
    static const std::array nodes{
        mix_node(),        mix_rgb_node(),        rgb_curve_node(),
        color_ramp_node(), hue_saturation_node(), bright_contrast_node(),
        gamma_node(),      invert_node(),
    };
    return nodes;
}

}  // namespace eye_render
