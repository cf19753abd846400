// The normal of a surface that a height lifts, from differences of the height between a point and
// two others nearby (Mikkelsen 2010, "Bump Mapping Unparametrized Surfaces on the GPU").

#pragma once

#include "shading/node.h"

#include <array>
#include <cmath>

namespace eye_render {

// Two steps along the surface, `width_px` pixels wide as they are seen from straight above: what
// is finer than a pixel is not seen, and steps much smaller would difference roundings. Their
// directions are those of Cycles, because a height that bends within a step tells them apart.
[[nodiscard]] inline std::array<V3f, 2> bump_offsets(const ShadingPoint& point,
                                                     const V3f& position_world,
                                                     float width_px = 1.0f)
{
    constexpr float least_roundings = 64.0f * 1.2e-7f;  // of the position's float steps
    const float largest = std::max(
        {std::abs(position_world.x), std::abs(position_world.y), std::abs(position_world.z)});
    const float width = std::max({point.footprint * width_px, least_roundings * largest, 1e-6f});
    const V3f& n = point.ng;
    const V3f diagonal(n.x == n.y && n.x == n.z ? -1.0f : 1.0f, 1.0f, 1.0f);
    const V3f s = diagonal.cross(n).normalized();
    return {s * width, n.cross(s) * width};
}

// `rise` are the heights at the offsets less the one here, world units.
[[nodiscard]] inline V3f bumped_normal(const V3f& normal,
                                       const std::array<V3f, 2>& offsets,
                                       const V2f& rise)
{
    const V3f across_1 = offsets[1].cross(normal);
    const V3f across_0 = normal.cross(offsets[0]);
    const V3f gradient = across_1 * rise.x + across_0 * rise.y;
    const float determinant = offsets[0].dot(across_1);
    const V3f bumped =
        normal * std::abs(determinant) - gradient * (determinant < 0.0f ? -1.0f : 1.0f);
    return unit_or(bumped, normal);
}

}  // namespace eye_render
