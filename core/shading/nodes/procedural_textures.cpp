#include "shading/nodes/node_tables.h"
#include "shading/nodes/procedural_nodes.h"

#include <array>

namespace eye_render {

std::span<const NodeType> procedural_texture_nodes()
{
    static const std::array nodes{
        noise_texture_node(),   white_noise_node(),      voronoi_texture_node(),
        wave_texture_node(),    magic_texture_node(),    brick_texture_node(),
        checker_texture_node(), gradient_texture_node(), gabor_texture_node(),
    };
    return nodes;
}

}  // namespace eye_render
