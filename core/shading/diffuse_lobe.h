// Wide lobes: LobeKind::Diffuse to DiffuseToon, and how their fields are made.

#pragma once

#include "shading/bsdf.h"

namespace eye_render {

// A Lambert surface seen through its own grains: Oren & Nayar 1994 in the form of Fujii 2012, "A
// tiny improvement of Oren-Nayar reflectance model", with what is scattered between the grains
// given back as in the OpenPBR specification 1.1. `roughness` in [0, 1], above 0; `color` is what
// the light between the grains is tinted by. All of it is `weight` times, albedo too.
struct LobeAndAlbedo {
    Lobe lobe;
    Color3f albedo;
};
[[nodiscard]] LobeAndAlbedo oren_nayar_lobe(const Color3f& weight,
                                            const Color3f& color,
                                            float roughness,
                                            const V3f& normal,
                                            const V3f& smooth_normal,
                                            const V3f& wo);

// Light from the far side, evenly. `normal` is on the viewer's.
[[nodiscard]] Lobe translucent_lobe(const Color3f& weight,
                                    const V3f& normal,
                                    const V3f& smooth_normal);

// Adds the sheen of fibres (sheen.h), `weight` times. `roughness` in [0, 1]. Returns the share of
// light that they scatter.
[[nodiscard]] float add_sheen(Bsdf& bsdf,
                              const Color3f& weight,
                              float roughness,
                              const V3f& normal,
                              const V3f& smooth_normal,
                              const V3f& wo);

// All light from a cone around the normal, or around the mirror direction: of half angle `size`,
// with an edge that fades over `smooth`, both as parts of a right angle. The weight is that of
// the cone's light; what the edge fades is lost.
[[nodiscard]] Lobe toon_lobe(LobeKind kind,
                             const Color3f& weight,
                             float size,
                             float smooth,
                             const V3f& normal,
                             const V3f& smooth_normal);

[[nodiscard]] BsdfValue evaluate_diffuse(const Lobe& lobe, const V3f& wo, const V3f& wi);
[[nodiscard]] V3f sample_diffuse(const Lobe& lobe, const V3f& wo, const V2f& u);

[[nodiscard]] BsdfValue evaluate_glossy_toon(const Lobe& lobe, const V3f& wo, const V3f& wi);
[[nodiscard]] V3f sample_glossy_toon(const Lobe& lobe, const V3f& wo, const V2f& u);

}  // namespace eye_render
