// Normal mapping and bending.

#include "shading/shading_normal.h"

#include "shading/material_input.h"
#include "shading/visible_normal.h"

#include <algorithm>

namespace eye_render {

V3f mapped_normal(const Material& material,
                  const ShadingPoint& point,
                  const HitAttributes& attributes)
{
    const MaterialInput& map = material.normal_map;
    if (map.texture == MaterialInput::none) {
        return point.ns;
    }
    const TangentFrame frame = attributes.tangent(map.uv_layer);
    if (frame.tangent.length2() == 0.0f) {
        return point.ns;
    }
    constexpr float largest_strength = 10.0f;  // Blender's
    const float strength =
        read_scalar(material.normal_strength, attributes, 0.0f, largest_strength);
    const Color3f texel = read_color(map, attributes);
    const float x = (2.0f * texel.x - 1.0f) * strength;
    const float y = (2.0f * texel.y - 1.0f) * strength;
    const float z = 1.0f + (2.0f * texel.z - 2.0f) * std::min(strength, 1.0f);

    // The map belongs to the mesh's own side, so it is applied to the normal before the turn to
    // the viewer.
    const float turn = point.backfacing ? -1.0f : 1.0f;
    const V3f own = point.ns * turn;
    const V3f bitangent = own.cross(frame.tangent) * frame.bitangent_sign;
    const V3f mapped = (frame.tangent * x + bitangent * y + own * z) * turn;
    const float length2 = mapped.length2();
    return length2 > 0.0f ? mapped / std::sqrt(length2) : point.ns;
}

V3f visible_normal(const V3f& normal, const ShadingPoint& point)
{
    return visible_normal(normal, point.wo, point.ng);
}

}  // namespace eye_render
