// Lobes of microfacets: LobeKind::Glossy to Refraction.
//
// Walter et al. 2007, "Microfacet Models for Refraction through Rough Surfaces", eq. 20 and 21,
// sampled by visible normals. Transmission is not scaled by the square of the index: radiance is
// traced as if it were basic radiance, as Cycles does, so that a window looks as bright as the
// hole it fills.

#pragma once

#include "shading/lobe.h"

namespace eye_render {

[[nodiscard]] BsdfValue evaluate_microfacet(const Lobe& lobe,
                                            const V3f& wo,
                                            const V3f& wi,
                                            bool transmitted);

[[nodiscard]] std::optional<LobeSample> sample_microfacet(const Lobe& lobe,
                                                          const V3f& wo,
                                                          float u_choice,
                                                          const V2f& u);

// What facets do to light that leaves them under `cos_facet`, weighed: the albedo of a smooth
// surface.
struct FacetAlbedo {
    Color3f reflected;
    Color3f transmitted;
};

[[nodiscard]] FacetAlbedo facet_albedo(const Lobe& lobe, float cos_facet);

}  // namespace eye_render
