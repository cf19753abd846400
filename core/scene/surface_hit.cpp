#include "scene/surface_hit.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

template <typename T>
T interpolate(const T& a, const T& b, const T& c, float u, float v)
{
    return a * (1.0f - u - v) + b * u + c * v;
}

// Unit normal of the triangle at (u, v) in object space, or `ng` where the mesh is flat there.
V3f interpolated_normal(const Mesh& mesh, std::uint32_t triangle, float u, float v)
{
    const V3f* n = mesh.normals.data();
    if (mesh.normal_domain == NormalDomain::PerVertex) {
        const TriangleIndices& corner = mesh.triangles[triangle];
        return interpolate(n[corner[0]], n[corner[1]], n[corner[2]], u, v);
    }
    const std::size_t first = 3 * std::size_t{triangle};
    return interpolate(n[first], n[first + 1], n[first + 2], u, v);
}

}  // namespace

float position_error(const Placement& placement, const std::array<V3f, 3>& corners)
{
    // Roundings of the barycentric sum and of Embree's intersection, each half a float step of the
    // largest coordinate they handle; measured on tilted planes up to 10 km wide.
    constexpr float roundings = 16.0f * 0.5f * std::numeric_limits<float>::epsilon();
    float largest = 0.0f;
    for (const V3f& p : corners) {
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    if (placement.is_flat) {
        return roundings * largest;
    }
    // The same once more for the way to the world, whose terms cancel near the eye.
    const M44f& m = placement.world_from_object;
    float world = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        world = std::max(
            world, (std::abs(m[0][axis]) + std::abs(m[1][axis]) + std::abs(m[2][axis])) * largest +
                       std::abs(m[3][axis]));
    }
    return 2.0f * roundings * world;
}

SurfaceHit make_surface_hit(const Ray& ray,
                            const AcceleratorHit& found,
                            const Placement& placement,
                            std::span<const V3f> positions)
{
    const Mesh& mesh = *placement.mesh;
    const TriangleIndices& corner = mesh.triangles[found.triangle];
    SurfaceHit hit;
    hit.t = found.t;
    hit.placement = &placement;
    hit.triangle = found.triangle;
    hit.u = found.u;
    hit.v = found.v;
    // From the barycentric coordinates, which is more exact than origin + t * direction far away.
    const std::array<V3f, 3> p{positions[corner[0]], positions[corner[1]], positions[corner[2]]};
    hit.p_world = interpolate(p[0], p[1], p[2], found.u, found.v);
    hit.p_error = position_error(placement, p);
    V3f ng = found.ng;
    if (placement.is_flat) {
        // A mirrored mesh has its winding reversed in world space.
        ng *= placement.is_mirrored ? -1.0f : 1.0f;
    } else {
        hit.p_world = hit.p_world * placement.world_from_object;
        ng = ng * placement.world_from_object_normal;
    }
    ng.normalize();

    ShadingPoint& point = hit.point;
    point.wo = -ray.direction;
    point.backfacing = ng.dot(point.wo) < 0.0f;
    point.ns = ng;
    if (mesh.normal_domain != NormalDomain::Flat) {
        const V3f ns = interpolated_normal(mesh, found.triangle, found.u, found.v) *
                       placement.world_from_object_normal;
        const float length = ns.length();
        // Opposite corner normals can cancel; NaN falls to the geometric normal as well.
        if (length > 0.0f) {
            point.ns = ns / length;
        }
    }
    point.ng = point.backfacing ? -ng : ng;
    point.ns = point.backfacing ? -point.ns : point.ns;
    return hit;
}

V2f MeshAttributes::uv(int uv_layer) const
{
    const int layer = placement_.layers->uv[static_cast<std::size_t>(uv_layer)];
    if (layer == LayerLookup::none) {
        return V2f(0.0f);
    }
    const auto& uvs = placement_.mesh->uv_layers[static_cast<std::size_t>(layer)].per_corner;
    const std::size_t first = 3 * std::size_t{triangle_};
    return interpolate(uvs[first], uvs[first + 1], uvs[first + 2], u_, v_);
}

TangentFrame MeshAttributes::tangent(int uv_layer) const
{
    const int layer = placement_.layers->uv[static_cast<std::size_t>(uv_layer)];
    if (layer == LayerLookup::none) {
        return {};
    }
    const Mesh& mesh = *placement_.mesh;
    const auto& uvs = mesh.uv_layers[static_cast<std::size_t>(layer)].per_corner;
    const std::size_t first = 3 * std::size_t{triangle_};
    const V2f uv1 = uvs[first + 1] - uvs[first];
    const V2f uv2 = uvs[first + 2] - uvs[first];
    const TriangleIndices& corner = mesh.triangles[triangle_];
    const V3f e1 = mesh.positions[corner[1]] - mesh.positions[corner[0]];
    const V3f e2 = mesh.positions[corner[2]] - mesh.positions[corner[0]];
    const float area = uv1.x * uv2.y - uv1.y * uv2.x;
    // Directions keep their side under the plain matrix, so the frame's handedness is the map's,
    // reversed where the object is mirrored.
    V3f tangent;
    placement_.world_from_object.multDirMatrix(
        (e1 * uv2.y - e2 * uv1.y) * (area < 0.0f ? -1.0f : 1.0f), tangent);
    const float length = tangent.length();
    if (!(length > 0.0f)) {
        return {};
    }
    const bool is_reversed = (area < 0.0f) != placement_.is_mirrored;
    return {.tangent = tangent / length, .bitangent_sign = is_reversed ? -1.0f : 1.0f};
}

Color4f MeshAttributes::color(int color_attribute) const
{
    const int layer = placement_.layers->color[static_cast<std::size_t>(color_attribute)];
    if (layer == LayerLookup::none) {
        return Color4f(0.0f);
    }
    const auto& colors =
        placement_.mesh->color_attributes[static_cast<std::size_t>(layer)].per_corner;
    const std::size_t first = 3 * std::size_t{triangle_};
    return interpolate(colors[first], colors[first + 1], colors[first + 2], u_, v_);
}

Color4f MeshAttributes::texture(int texture, const V2f& uv) const
{
    return textures_.lookup(texture, uv);
}

}  // namespace eye_render
