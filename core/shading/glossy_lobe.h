// Glossy lobes that are not of Walter's microfacets: the velvet of Ashikhmin, Premoze & Shirley
// 2000, "A Microfacet-based BRDF Generator", and the Phong-like lobe of Ashikhmin & Shirley 2000,
// "An Anisotropic Phong BRDF Model", without its Fresnel.

#pragma once

#include "shading/lobe.h"

namespace eye_render {

// `sigma` in [0, 1]: how wide the fibres stand from the surface.
[[nodiscard]] Lobe velvet_lobe(const Color3f& weight, const V3f& normal, float sigma);

[[nodiscard]] BsdfValue evaluate_velvet(const Lobe& lobe, const V3f& wo, const V3f& wi);
[[nodiscard]] V3f sample_velvet(const Lobe& lobe, const V2f& u);

[[nodiscard]] BsdfValue evaluate_ashikhmin_shirley(const Lobe& lobe, const V3f& wo, const V3f& wi);
// Nothing where the facet that was drawn faces away from the viewer.
[[nodiscard]] std::optional<V3f> sample_ashikhmin_shirley(const Lobe& lobe,
                                                          const V3f& wo,
                                                          const V2f& u);

}  // namespace eye_render
