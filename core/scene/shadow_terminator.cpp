#include "scene/shadow_terminator.h"

#include "scene/barycentric.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eye_render {

namespace {

using Corners = std::array<V3f, 3>;

// Of the corner's tangent plane above `p`, moved out until the other two corners are below it.
float height_of_tangent_plane(std::size_t corner, const Corners& v, const Corners& n, const V3f& p)
{
    const V3f& q = v[(corner + 1) % 3];
    const V3f& r = v[(corner + 2) % 3];
    const float out =
        std::max({(q - v[corner]).dot(n[corner]), (r - v[corner]).dot(n[corner]), 0.0f});
    return std::max((v[corner] - p).dot(n[corner]) + out, 0.0f);
}

// Along the interpolated normal, in object space; `p` has the weights u and w of the first two
// corners. The normals point to the side that the surface bulges to.
float height_of_bulge(const Corners& v, const Corners& n, float u, float w, const V3f& p)
{
    const float a = (n[2] - n[0]).dot(v[0] - v[2]);
    const float b = (n[2] - n[1]).dot(v[1] - v[2]);
    const float c = (n[1] - n[0]).dot(v[1] - v[0]);
    const float parabola = a * u * (u - 1.0f) + (a + b + c) * u * w + b * w * (w - 1.0f);
    const float envelope =
        std::min({height_of_tangent_plane(0, v, n, p), height_of_tangent_plane(1, v, n, p),
                  height_of_tangent_plane(2, v, n, p)});
    return std::max(envelope, 0.5f * parabola);
}

}  // namespace

V3f terminator_offset(const SurfaceHit& hit, const V3f& wi)
{
    const float cutoff = hit.placement->terminator_cosine;
    const Mesh* const mesh = hit.placement->mesh();
    if (!(cutoff > 0.0f) || mesh == nullptr || mesh->normal_domain == NormalDomain::Flat) {
        return V3f(0.0f);
    }
    const float side = hit.point.ns.dot(wi) < 0.0f ? -1.0f : 1.0f;
    const float cos_smooth = side * hit.point.ns.dot(wi);
    const float cos_flat = side * hit.point.ng.dot(wi);
    // Softly, over another cutoff; the face itself shadows what is lit from behind it.
    const float share =
        cos_smooth < cutoff ? 2.0f - (cos_flat + cos_smooth) / cutoff : 1.0f - cos_flat / cutoff;
    if (!(share > 0.0f && cos_flat > 0.0f)) {
        return V3f(0.0f);
    }
    const std::uint32_t triangle = hit.primitive;
    const Corners v = mesh->corners(triangle, hit.time);
    Corners n{interpolated_normal(*mesh, triangle, 0.0f, 0.0f, hit.time),
              interpolated_normal(*mesh, triangle, 1.0f, 0.0f, hit.time),
              interpolated_normal(*mesh, triangle, 0.0f, 1.0f, hit.time)};
    const Pose& pose = hit.placement->pose;
    const V3f normal_world =
        interpolate(n[0], n[1], n[2], hit.u, hit.v) * pose.world_from_object_normal;
    // Seen from inside, the surface bulges away.
    if (normal_world.dot(hit.point.ng * side) < 0.0f) {
        for (V3f& each : n) {
            each = -each;
        }
    }
    const V3f p = interpolate(v[0], v[1], v[2], hit.u, hit.v);
    const float height = height_of_bulge(v, n, 1.0f - hit.u - hit.v, hit.u, p);
    V3f offset;
    pose.world_from_object.multDirMatrix(
        interpolate(n[0], n[1], n[2], hit.u, hit.v) * (height * std::min(share, 1.0f)), offset);
    return offset;
}

}  // namespace eye_render
