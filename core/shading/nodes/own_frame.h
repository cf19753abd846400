// The directions of a UV layer at a hit, where Blender lays out what bends and moves a surface. A
// mesh may bring tangents that are smoothed (by MikkTSpace, as normal maps are baked) as an
// attribute; else they are those of each triangle.

#pragma once

#include "shading/node.h"
#include "shading/object_space.h"

#include <string>

namespace eye_render {

// The attribute's name, as in Cycles: x, y and z of the object's own space, and in alpha the sign
// of the bitangent, B = sign * cross(N, T).
[[nodiscard]] inline std::string tangent_attribute(const std::string& uv_layer)
{
    return uv_layer + ".tangent";
}

// A UV layer, and the attribute that has its smoothed tangents.
struct TangentSource {
    int uv_layer = HitAttributes::active_uv_layer;
    int attribute = 0;

    // For those that ask for none.
    TangentSource() = default;
    TangentSource(const std::string& layer, NodeResources& resources)
        : uv_layer(resources.uv_layer(layer)),
          attribute(resources.attribute(tangent_attribute(layer)))
    {
    }
};

struct OwnTangent {
    V3f tangent{0.0f};  // unit, in the object's own space; zero if there is none
    float bitangent_sign = 1.0f;
};

[[nodiscard]] inline OwnTangent own_tangent(const Hit& hit, const TangentSource& source)
{
    const AttributeValue smoothed = hit.attributes.attribute(source.attribute);
    if (smoothed.exists) {
        const Color4f& c = smoothed.value;
        return {.tangent = unit_or(V3f(c.r, c.g, c.b), V3f(0.0f)),
                .bitangent_sign = c.a < 0.0f ? -1.0f : 1.0f};
    }
    const TangentFrame frame = hit.attributes.tangent(source.uv_layer);
    const ObjectFacts& object = hit.attributes.object();
    const bool is_mirrored = object.world_from_object.determinant() < 0.0f;
    return {.tangent = unit_or(vector_to_object(object, frame.tangent), V3f(0.0f)),
            .bitangent_sign = is_mirrored ? -frame.bitangent_sign : frame.bitangent_sign};
}

// A UV layer's directions in the object's own space, where Blender lays its maps: the object may
// stretch them. Unit; the tangent is zero where the layer has none.
struct OwnFrame {
    V3f tangent{0.0f};
    V3f bitangent{0.0f};
    V3f normal{0.0f};

    // `normal_world` on the side that the frame shall have.
    OwnFrame(const Hit& hit, const TangentSource& source, const V3f& normal_world)
    {
        const auto [own, sign] = own_tangent(hit, source);
        if (own.length2() == 0.0f) {
            return;
        }
        tangent = own;
        normal = unit_or(normal_to_object(hit.attributes.object(), normal_world), normal_world);
        bitangent = unit_or(normal.cross(tangent), V3f(0.0f)) * sign;
    }
};

}  // namespace eye_render
