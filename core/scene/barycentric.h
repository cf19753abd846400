// Values of a triangle's corners at the point with weights 1 - u - v, u and v, as Embree numbers
// them. Outside the triangle, too, where bump mapping looks.

#pragma once

#include "scene/mesh.h"

namespace eye_render {

template <typename T>
[[nodiscard]] T interpolate(const T& a, const T& b, const T& c, float u, float v)
{
    return a * (1.0f - u - v) + b * u + c * v;
}

// Of values that have three entries a triangle.
template <typename T>
[[nodiscard]] T interpolate_corners(const std::vector<T>& per_corner,
                                    std::uint32_t triangle,
                                    float u,
                                    float v)
{
    const std::size_t first = 3 * std::size_t{triangle};
    return interpolate(per_corner[first], per_corner[first + 1], per_corner[first + 2], u, v);
}

// In object space, of any length; the mesh is not flat.
[[nodiscard]] inline V3f interpolated_normal(const Mesh& mesh,
                                             std::uint32_t triangle,
                                             float u,
                                             float v,
                                             float time)
{
    const auto normal = [&](std::size_t corner) {
        const std::size_t index = mesh.normal_domain == NormalDomain::PerVertex
                                      ? mesh.triangles[triangle][corner]
                                      : 3 * std::size_t{triangle} + corner;
        return at_time(mesh.normals, mesh.motion_normals, index, time);
    };
    return interpolate(normal(0), normal(1), normal(2), u, v);
}

}  // namespace eye_render
