// One lobe of a BSDF mixture. World space, unit directions away from the surface; radiance flows
// from wi to wo, and wo is on the side of the lobe's normal unless the lobe is diffuse.

#pragma once

#include "base/vector.h"

#include <cstdint>
#include <optional>

namespace eye_render {

struct BsdfValue {
    Color3f value{0.0f};  // f(wo, wi) |cos(ns, wi)|, delta lobes left out
    float pdf = 0.0f;     // of `sample` choosing wi, delta lobes left out
};

enum class LobeKind : std::uint8_t {
    Straight,    // passes light as if there were no surface
    Diffuse,     // Lambert
    Glossy,      // GGX reflection without Fresnel
    Metal,       // GGX reflection, Schlick's Fresnel from `f0` to white
    Dielectric,  // GGX reflection, dielectric Fresnel
    Glass,       // GGX reflection and transmission, dielectric Fresnel
};

// Made by the functions below only. Without initialisers because a mixture holds room for several
// per hit, and clearing it would cost a tenth of shading.
struct Lobe {
    LobeKind kind;
    Color3f weight;
    V3f normal;
    V3f smooth_normal;     // Diffuse: the normal before the normal map
    float alpha;           // GGX kinds; below smallest_rough_alpha a delta
    float ior;             // Dielectric, Glass: of the far side over the near side
    Color3f f0;            // Metal
    Color3f transmission;  // Glass: weight of what passes; `weight` is of what is reflected

    [[nodiscard]] bool is_delta() const;
};

[[nodiscard]] Lobe straight_lobe(const Color3f& weight);
[[nodiscard]] Lobe diffuse_lobe(const Color3f& weight,
                                const V3f& normal,
                                const V3f& smooth_normal);
[[nodiscard]] Lobe glossy_lobe(const Color3f& weight, const V3f& normal, float alpha);
[[nodiscard]] Lobe metal_lobe(const Color3f& weight,
                              const V3f& normal,
                              float alpha,
                              const Color3f& f0);
[[nodiscard]] Lobe dielectric_lobe(const Color3f& weight,
                                   const V3f& normal,
                                   float alpha,
                                   float ior);
[[nodiscard]] Lobe glass_lobe(const Color3f& reflection,
                              const Color3f& transmission,
                              const V3f& normal,
                              float alpha,
                              float ior);

// `transmitted` says that wi is on the far side of the geometry; where the lobe's normal
// disagrees the value is zero. Not for delta lobes.
[[nodiscard]] BsdfValue evaluate(const Lobe& lobe, const V3f& wo, const V3f& wi, bool transmitted);

struct LobeSample {
    V3f wi;
    bool is_transmitted = false;
    Color3f delta_weight{0.0f};  // of a delta lobe: value over probability
};

// Nothing if no light comes from what was drawn. `u_choice` decides between reflection and
// transmission.
[[nodiscard]] std::optional<LobeSample> sample(const Lobe& lobe,
                                               const V3f& wo,
                                               float u_choice,
                                               const V2f& u);

}  // namespace eye_render
