#include "scene/surface_hit.h"

#include "scene/barycentric.h"
#include "scene/transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

// Roundings of the barycentric sum and of Embree's intersection, each half a float step of the
// largest coordinate they handle; measured on tilted planes up to 10 km wide.
constexpr float roundings = 16.0f * 0.5f * std::numeric_limits<float>::epsilon();

// How far from a round strand or ball Embree's hit may lie, by its radius.
constexpr float search_error = 1e-3f;

float largest_coordinate(const V3f& p)
{
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

// As large as a coordinate may become on the way to the world, whose terms cancel near the eye.
float largest_in_world(const Pose& pose, float largest_in_object)
{
    const M44f& m = pose.world_from_object;
    float world = 0.0f;
    for (int axis = 0; axis < 3; ++axis) {
        world =
            std::max(world, (std::abs(m[0][axis]) + std::abs(m[1][axis]) + std::abs(m[2][axis])) *
                                    largest_in_object +
                                std::abs(m[3][axis]));
    }
    return world;
}

// The side that the winding calls the front is not always the viewer's.
void turn_to_viewer(ShadingPoint& point, const V3f& ng, const V3f& ns)
{
    point.backfacing = ng.dot(point.wo) < 0.0f;
    point.ng = point.backfacing ? -ng : ng;
    point.ns = point.backfacing ? -ns : ns;
}

void complete(SurfaceHit& hit,
              const Mesh& mesh,
              const AcceleratorHit& found,
              const Pose& pose,
              const MotionSteps<V3f>& positions)
{
    const Placement& placement = *hit.placement;
    const TriangleIndices& corner = mesh.triangles[found.primitive];
    // From the barycentric coordinates, which is more exact than origin + t * direction far away.
    const std::array<V3f, 3> p{positions.at(corner[0], hit.time),
                               positions.at(corner[1], hit.time),
                               positions.at(corner[2], hit.time)};
    hit.p_world = interpolate(p[0], p[1], p[2], found.u, found.v);
    hit.p_error = position_error(placement, p);
    V3f ng = found.ng;
    if (placement.is_flat) {
        // A mirrored mesh has its winding reversed in world space.
        ng *= placement.is_mirrored ? -1.0f : 1.0f;
    } else {
        hit.p_world = hit.p_world * pose.world_from_object;
        ng = ng * pose.world_from_object_normal;
    }
    ng.normalize();
    V3f ns = ng;
    if (mesh.normal_domain != NormalDomain::Flat) {
        // Opposite corner normals can cancel; NaN falls to the geometric normal as well.
        ns = unit_or(interpolated_normal(mesh, found.primitive, found.u, found.v, hit.time) *
                         pose.world_from_object_normal,
                     ng);
    }
    turn_to_viewer(hit.point, ng, ns);
}

// Out of the circle around the axis, where the flat ribbon stands for a round strand.
V3f ribbon_normal(const V3f& axis, const V3f& wo, float across)
{
    const V3f side = unit_or(axis.cross(wo), V3f(0.0f));
    const V3f front = unit_or(side.cross(axis), wo);
    const V3f normal = side * across + front * std::sqrt(std::max(0.0f, 1.0f - across * across));
    return unit_or(normal, wo);
}

void complete(SurfaceHit& hit, const Curves& curves, const AcceleratorHit& found, const Pose& pose)
{
    const StrandPlace place = strand_place(curves, found.primitive, found.u);
    hit.strand = {.placement = found.placement,
                  .first = curves.first_segment(place.strand),
                  .end = curves.first_segment(place.strand + 1)};
    const StrandPoint strand = strand_point(curves, place, hit.time);
    if (curves.shape == StrandShape::Ribbon) {
        V3f axis;
        pose.world_from_object.multDirMatrix(strand.derivative, axis);
        hit.point.ng = ribbon_normal(axis, hit.point.wo, std::clamp(found.v, -1.0f, 1.0f));
        hit.point.ns = hit.point.ng;
        return;
    }
    hit.p_error += search_error * strand.at.radius * scale_of(pose.world_from_object);
    V3f normal = hit.placement->is_flat ? found.ng : found.ng * pose.world_from_object_normal;
    if (curves.shape == StrandShape::Round) {
        // Away from the axis, whatever the taper, as in Cycles: the strand is round in the space
        // that the accelerator holds it in.
        normal = hit.placement->is_flat
                     ? hit.p_world - strand.at.center * pose.world_from_object
                     : (hit.p_world * pose.world_from_object.inverse() - strand.at.center) *
                           pose.world_from_object_normal;
    }
    normal = unit_or(normal, hit.point.wo);
    turn_to_viewer(hit.point, normal, normal);
}

void complete(SurfaceHit& hit, const Points& points, const AcceleratorHit& found, const Pose& pose)
{
    const SizedPoint ball = at_time(points.points, points.motion, found.primitive, hit.time);
    const V3f normal = unit_or(found.ng, V3f(0.0f, 0.0f, 1.0f));
    const M44f& m = pose.world_from_object;
    if (hit.placement->is_flat) {
        hit.p_world = ball.center * m + normal * (ball.radius * scale_of(m));
        hit.point.ng = normal;
    } else {
        hit.p_world = (ball.center + normal * ball.radius) * m;
        hit.point.ng = unit_or(normal * pose.world_from_object_normal, hit.point.wo);
    }
    hit.p_error =
        2.0f * roundings * largest_in_world(pose, largest_coordinate(ball.center) + ball.radius) +
        search_error * ball.radius * scale_of(m);
    hit.point.ns = hit.point.ng;
}

}  // namespace

float position_error(const Placement& placement, const std::array<V3f, 3>& corners)
{
    float largest = 0.0f;
    for (const V3f& p : corners) {
        largest = std::max(largest, largest_coordinate(p));
    }
    return placement.is_flat ? roundings * largest
                             : 2.0f * roundings * largest_in_world(placement.pose, largest);
}

SurfaceHit make_surface_hit(const Ray& ray,
                            const AcceleratorHit& found,
                            const Placement& placement,
                            const Pose& pose,
                            const MotionSteps<V3f>& positions)
{
    SurfaceHit hit;
    hit.t = found.t;
    hit.placement = &placement;
    hit.primitive = found.primitive;
    hit.u = found.u;
    hit.v = found.v;
    hit.time = ray.time;
    hit.point.wo = -ray.direction;
    if (const Mesh* const mesh = placement.mesh()) {
        complete(hit, *mesh, found, pose, positions);
        return hit;
    }
    // Rays that leave strands and balls do not meet them again: near enough are the ray's
    // roundings.
    hit.p_world = ray.origin + ray.direction * found.t;
    hit.p_error = roundings * (largest_coordinate(ray.origin) + found.t);
    if (const Curves* const curves = std::get_if<Curves>(placement.geometry)) {
        complete(hit, *curves, found, pose);
    } else {
        complete(hit, std::get<Points>(*placement.geometry), found, pose);
    }
    return hit;
}

}  // namespace eye_render
