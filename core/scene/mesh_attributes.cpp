#include "scene/mesh_attributes.h"

#include "scene/barycentric.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

V3f MeshAttributes::position_object() const
{
    const auto [p0, p1, p2] = mesh_.corners(primitive_, time_);
    return interpolate(p0, p1, p2, u_, v_);
}

V3f MeshAttributes::position_world() const
{
    return {V3d(position_object() * pose_.world_from_object) + frame_.eye_position_world};
}

V2f MeshAttributes::uv(int uv_layer) const
{
    const int layer = placement_.layers->uv[static_cast<std::size_t>(uv_layer)];
    if (layer == LayerLookup::none) {
        return V2f(0.0f);
    }
    return interpolate_corners(mesh_.uv_layers[static_cast<std::size_t>(layer)].per_corner,
                               primitive_, u_, v_);
}

TangentFrame MeshAttributes::tangent(int uv_layer) const
{
    const int layer = placement_.layers->uv[static_cast<std::size_t>(uv_layer)];
    if (layer == LayerLookup::none) {
        return {};
    }
    const auto& uvs = mesh_.uv_layers[static_cast<std::size_t>(layer)].per_corner;
    const std::size_t first = 3 * std::size_t{primitive_};
    const V2f uv1 = uvs[first + 1] - uvs[first];
    const V2f uv2 = uvs[first + 2] - uvs[first];
    const auto [p0, p1, p2] = mesh_.corners(primitive_, time_);
    const V3f e1 = p1 - p0;
    const V3f e2 = p2 - p0;
    const float area = uv1.x * uv2.y - uv1.y * uv2.x;
    // Directions keep their side under the plain matrix, so the frame's handedness is the map's,
    // reversed where the object is mirrored.
    V3f tangent;
    pose_.world_from_object.multDirMatrix((e1 * uv2.y - e2 * uv1.y) * (area < 0.0f ? -1.0f : 1.0f),
                                          tangent);
    const float length = tangent.length();
    if (!(length > 0.0f)) {
        return {};
    }
    const bool is_reversed = (area < 0.0f) != placement_.is_mirrored;
    return {.tangent = tangent / length, .bitangent_sign = is_reversed ? -1.0f : 1.0f};
}

AttributeValue MeshAttributes::attribute(int attribute) const
{
    const int layer = placement_.layers->attributes[static_cast<std::size_t>(attribute)];
    if (layer == LayerLookup::none) {
        return object_property(attribute);
    }
    return {.value = interpolate_corners(
                mesh_.attributes[static_cast<std::size_t>(layer)].per_corner, primitive_, u_, v_),
            .exists = true};
}

std::array<V3f, 3> MeshAttributes::corners_world() const
{
    std::array<V3f, 3> corners = mesh_.corners(primitive_, time_);
    for (V3f& p : corners) {
        p = p * pose_.world_from_object;
    }
    return corners;
}

float MeshAttributes::edge_distance() const
{
    const auto [p0, p1, p2] = corners_world();
    const float double_area = (p1 - p0).cross(p2 - p0).length();
    // A weight is the distance to the opposite edge over the triangle's height there.
    const auto distance = [double_area](float weight, const V3f& edge) {
        const float length = edge.length();
        return length > 0.0f ? weight * double_area / length : 0.0f;
    };
    return std::min(
        {distance(1.0f - u_ - v_, p2 - p1), distance(u_, p2 - p0), distance(v_, p1 - p0)});
}

V3f MeshAttributes::smooth_normal() const
{
    const auto [p0, p1, p2] = corners_world();
    V3f flat = unit_or((p1 - p0).cross(p2 - p0), V3f(0.0f, 0.0f, 1.0f));
    if (placement_.is_mirrored) {
        flat = -flat;
    }
    return mesh_.normal_domain == NormalDomain::Flat
               ? flat
               : unit_or(interpolated_normal(mesh_, primitive_, u_, v_, time_) *
                             pose_.world_from_object_normal,
                         flat);
}

void MeshAttributes::moved(const V3f& offset,
                           const std::function<void(const HitAttributes&)>& look) const
{
    const auto [p0, p1, p2] = corners_world();
    const V3f e1 = p1 - p0;
    const V3f e2 = p2 - p0;
    // Weights of the offset along the two edges, by least squares.
    const float a = e1.dot(e1);
    const float b = e1.dot(e2);
    const float c = e2.dot(e2);
    const float determinant = a * c - b * b;
    if (!(determinant > 0.0f)) {
        look(*this);
        return;
    }
    const float d1 = e1.dot(offset);
    const float d2 = e2.dot(offset);
    look(MeshAttributes(placement_, pose_, primitive_, u_ + (c * d1 - b * d2) / determinant,
                        v_ + (a * d2 - b * d1) / determinant, time_, frame_));
}

}  // namespace eye_render
