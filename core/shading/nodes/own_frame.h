// The directions of a UV layer at a hit, where Blender lays out what bends and moves a surface.

#pragma once

#include "shading/node.h"
#include "shading/object_space.h"

namespace eye_render {

// A UV layer's directions in the object's own space, where Blender lays its maps: the object may
// stretch them. Unit; the tangent is zero where the layer has none.
struct OwnFrame {
    V3f tangent{0.0f};
    V3f bitangent{0.0f};
    V3f normal{0.0f};

    // `normal_world` on the side that the frame shall have.
    OwnFrame(const Hit& hit, int uv_layer, const V3f& normal_world)
    {
        const TangentFrame frame = hit.attributes.tangent(uv_layer);
        if (frame.tangent.length2() == 0.0f) {
            return;
        }
        const ObjectFacts& object = hit.attributes.object();
        tangent = unit_or(vector_to_object(object, frame.tangent), V3f(0.0f));
        normal = unit_or(normal_to_object(object, normal_world), normal_world);
        const bool is_mirrored = object.world_from_object.determinant() < 0.0f;
        bitangent = unit_or(normal.cross(tangent), V3f(0.0f)) *
                    (is_mirrored ? -frame.bitangent_sign : frame.bitangent_sign);
    }
};

}  // namespace eye_render
