// The list of closures: Blender's surface shaders, under the identifiers of Blender 4.3.

#include "shading/nodes/closure_nodes.h"
#include "shading/nodes/node_tables.h"

namespace eye_render {

std::span<const NodeType> closure_nodes()
{
    static const NodeType nodes[] = {
        principled_node(), diffuse_node(),    glossy_node(),      glass_node(),
        emission_node(),   background_node(), transparent_node(), holdout_node(),
    };
    return nodes;
}

}  // namespace eye_render
