// Light on a fibre of hair: LobeKind::Fibre.
//
// A cylinder of clear, coloured and slightly rough glass with tilted scales: Chiang, Bitterli,
// Tappan & Burley 2016, "A Practical and Controllable Hair and Fur Model for Production Path
// Tracing". Light is reflected (R), passes through (TT), is reflected once inside (TRT), or more
// often, each spread along the fibre as d'Eon, Francois, Hill, Letteri & Aubry 2011, "An
// Energy-Conserving Hair Reflectance Model", have it (M), and around it by a logistic distribution
// (N). Where on the fibre's width it falls is told by the geometric normal.

#pragma once

#include "shading/lobe.h"

namespace eye_render {

struct Fibre {
    Color3f absorption{0.0f};  // along a radius
    // As artists set them, 0 to 1: along the fibre and around it, and the first relative to it for
    // light that is reflected.
    float roughness = 0.3f;
    float radial_roughness = 0.3f;
    float gloss_roughness = 1.0f;
    float ior = 1.55f;
    float tilt_rad = 0.0f;  // of the scales, towards the root
};

struct FibreAlbedo {
    Color3f reflected{0.0f};
    Color3f transmitted{0.0f};  // TT and what goes further
};

// `along` points from root to tip, of any length; `ng` is the geometric normal.
[[nodiscard]] Lobe fibre_lobe(float weight, const Fibre& fibre, const V3f& along, const V3f& ng);
// Weighed.
[[nodiscard]] FibreAlbedo fibre_albedo(const Lobe& lobe, const V3f& wo);

[[nodiscard]] BsdfValue evaluate_fibre(const Lobe& lobe, const V3f& wo, const V3f& wi);
[[nodiscard]] V3f sample_fibre(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u);

// Variance and scale are at least this afterwards.
void blur_fibre(Lobe& lobe, float least);

}  // namespace eye_render
