// The list of closures: Blender's shaders of surfaces and volumes, under the identifiers of
// Blender 4.3.

#include "shading/nodes/closure_nodes.h"
#include "shading/nodes/node_tables.h"

namespace eye_render {

V3f tangent_input_value(const NodeInputs& in, std::size_t input)
{
    const V3f linked = in.vector(input);
    if (linked.length2() > 0.0f) {
        return linked;
    }
    const HitAttributes& attributes = in.hit().attributes;
    const V3f generated = attributes.generated();
    const V3f around(0.5f - generated.y, generated.x - 0.5f, 0.0f);
    // As a normal is brought to the world.
    const M44f& m = attributes.object().object_from_world;
    const V3f around_world(around.x * m[0][0] + around.y * m[0][1],
                           around.x * m[1][0] + around.y * m[1][1],
                           around.x * m[2][0] + around.y * m[2][1]);
    const V3f& n = in.hit().point.ns;
    return n.cross(around_world.cross(n));
}

std::span<const NodeType> closure_nodes()
{
    static const auto nodes = std::to_array<NodeType>({
        principled_node(),
        diffuse_node(),
        translucent_node(),
        toon_node(),
        sheen_node(),
        subsurface_node(),
        glossy_node(),
        glass_node(),
        refraction_node(),
        metallic_node(),
        emission_node(),
        background_node(),
        transparent_node(),
        holdout_node(),
        hair_node(),
        principled_hair_node(),
        volume_absorption_node(),
        volume_scatter_node(),
        volume_coefficients_node(),
        principled_volume_node(),
    });
    return nodes;
}

}  // namespace eye_render
