// Normals that lobes can be built around. World space; every argument but `normal` is unit.

#pragma once

#include "base/vector.h"

#include <algorithm>

namespace eye_render {

// A normal as a socket brings it: any length, and `fallback` where it has none.
[[nodiscard]] inline V3f unit_normal(const V3f& normal, const V3f& fallback)
{
    if (normal == fallback) {
        return fallback;
    }
    const float length = normal.length();
    return length > 0.0f && length < 1e18f ? normal / length : fallback;
}

// `normal`, bent as little as it takes for the mirror direction of wo to leave the surface:
// interpolated and mapped normals may turn it below the geometry, or face away from the viewer,
// and a mirror would be black there. By the lifted mirror direction of Keller et al. 2017, "The
// Iray Light Transport Simulation and Rendering System". dot(wo, ng) > 0.
[[nodiscard]] inline V3f visible_normal(const V3f& normal, const V3f& wo, const V3f& ng)
{
    // Sines of the least elevation of the mirror direction: Cycles' choice.
    constexpr float least_elevation = 0.01f;
    constexpr float least_share_of_viewer = 0.9f;

    const float cos_o = normal.dot(wo);
    const V3f mirrored = normal * (2.0f * cos_o) - wo;
    const float lift =
        std::min(least_share_of_viewer * ng.dot(wo), least_elevation) - ng.dot(mirrored);
    if (cos_o > 0.0f && lift <= 0.0f) {
        return normal;
    }
    const V3f lifted = (mirrored + ng * std::max(0.0f, lift)).normalized();
    return (wo + lifted).normalized();
}

}  // namespace eye_render
