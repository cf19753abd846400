#include "scene/surface_hit.h"

#include "scene/barycentric.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

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

}  // namespace eye_render
