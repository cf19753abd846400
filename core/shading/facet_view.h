// A rough GGX surface seen under one angle: what its facets do to light, and a deterministic
// quadrature over those that are seen.

#pragma once

#include "base/warp.h"
#include "shading/microfacet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace eye_render {

struct FacetPoint {
    V2f u;  // for sample_visible_normal
    float weight;
};

// Facets of one height lie on a circle of the disk that `sample_visible_normal` maps, and the
// steep ones, which lose the light, at its rim: so points crowd there. One half of the disk is
// enough, the other is its mirror image. The points are a Fibonacci lattice.
[[nodiscard]] inline const auto& facet_points()
{
    constexpr int count = 377;
    constexpr int previous = 233;
    static const auto points = [] {
        std::array<FacetPoint, count> made{};
        for (int i = 0; i < count; ++i) {
            const float inward = (static_cast<float>(i) + 0.5f) / count;
            const float turn = (static_cast<float>(i * previous % count) + 0.5f) / count;
            const float radius = std::sqrt(1.0f - inward * inward * inward);
            const float phi = std::numbers::pi_v<float> * turn;
            made[static_cast<std::size_t>(i)] = {
                invert_uniform_disk({radius * std::cos(phi), radius * std::sin(phi)}),
                3.0f * inward * inward / count};
        }
        return made;
    }();
    return points;
}

// Cosines of a facet's normal against wo and against the surface's normal.
struct Facet {
    float cos_o;
    float cos_m;
};

struct FacetView {
    float alpha;
    float cos_o;
    float smith_o;

    FacetView(float roughness, float cos_viewer)
        : alpha(roughness * roughness), cos_o(std::max(cos_viewer, smallest_cos)),
          smith_o(smith_term(alpha * alpha, cos_o))
    {
    }

    // Part of what a facet scatters towards `cos_i` that no other facet shadows: G2 / G1. Nothing
    // leaves below the surface.
    [[nodiscard]] float unshadowed(float cos_i) const
    {
        if (!(cos_i > 0.0f)) {
            return 0.0f;
        }
        return masking_shadowing_over_cos(cos_o, smith_o, cos_i,
                                          smith_term(alpha * alpha, cos_i)) /
               masking_over_cos(cos_o, smith_o);
    }

    // Cosine of the mirrored direction against the surface: negative below it.
    [[nodiscard]] float reflected_cos(const Facet& m) const
    {
        return 2.0f * m.cos_o * m.cos_m - cos_o;
    }

    // The same for the refracted direction, against the other side of the surface.
    [[nodiscard]] float refracted_cos(const Facet& m, float ior, float cos_transmitted) const
    {
        return cos_o / ior - (m.cos_o / ior - cos_transmitted) * m.cos_m;
    }

    // Calls use(facet, weight) for points that sample the facets seen; the weights add up to 1.
    template <typename Use>
    void for_each_facet(Use&& use) const
    {
        const V3f wo(std::sqrt(1.0f - cos_o * cos_o), 0.0f, cos_o);
        for (const FacetPoint& point : facet_points()) {
            const V3f m = sample_visible_normal(wo, alpha, point.u);
            use(Facet{std::clamp(wo.dot(m), 0.0f, 1.0f), m.z}, point.weight);
        }
    }

private:
    // At cosine 0 no facet is seen.
    static constexpr float smallest_cos = 1e-4f;
};

}  // namespace eye_render
