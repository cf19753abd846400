// A rough GGX surface seen under one angle: what its facets do to light, and a deterministic
// quadrature over those that are seen.

#pragma once

#include "base/warp.h"
#include "shading/microfacet.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

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
    // Facets of one height lie on a circle of the square that `sample_visible_normal` maps, and
    // the steep ones, which lose the light, at its rim: so points crowd there. One half of each
    // circle is enough, the other is its mirror image.
    template <typename Use>
    void for_each_facet(Use&& use) const
    {
        constexpr int circles = 24;
        constexpr int points = 12;
        const auto outside = [](float circle) {
            const float v = circle / circles;
            return v * v * v;
        };
        const V3f wo(std::sqrt(1.0f - cos_o * cos_o), 0.0f, cos_o);
        for (int i = 0; i < circles; ++i) {
            const float circle = static_cast<float>(i);
            const float radius = std::sqrt(1.0f - outside(circle + 0.5f));
            const float weight = (outside(circle + 1.0f) - outside(circle)) / points;
            for (int j = 0; j < points; ++j) {
                const float phi =
                    std::numbers::pi_v<float> * (static_cast<float>(j) + 0.5f) / points;
                const V2f u =
                    invert_uniform_disk({radius * std::cos(phi), radius * std::sin(phi)});
                const V3f m = sample_visible_normal(wo, alpha, u);
                use(Facet{std::clamp(wo.dot(m), 0.0f, 1.0f), m.z}, weight);
            }
        }
    }

private:
    // At cosine 0 no facet is seen.
    static constexpr float smallest_cos = 1e-4f;
};

}  // namespace eye_render
