// A mixture of scattering lobes at one hit, built on the stack per hit and sampled as one
// distribution. World space, all directions unit and pointing away from the surface; radiance
// flows from wi to wo. Probabilities are per unit solid angle.

#pragma once

#include "base/vector.h"

#include <array>
#include <optional>

namespace eye_render {

struct BsdfValue {
    Color3f value{0.0f};  // f(wo, wi) |cos(ns, wi)|, delta lobes left out
    float pdf = 0.0f;     // of `sample` choosing wi, delta lobes left out
};

struct BsdfSample {
    V3f wi;
    Color3f weight;        // f |cos| / pdf of the whole mixture; for a delta lobe, of that lobe over its probability
    float pdf = 0.0f;      // of the whole mixture; 0 for a delta lobe
    bool is_delta = false;
    // Passed straight through, as if the surface were not there: not a bounce.
    bool is_straight = false;
};

class Bsdf {
public:
    Bsdf() = default;

    // Zero value and zero pdf where no lobe but a delta could send light.
    [[nodiscard]] BsdfValue evaluate(const V3f& wi) const;

    // `u_lobe` and both of `u` in [0, 1). Nothing if the light that was drawn is absorbed or
    // would leave through the wrong side of the surface: the path ends.
    [[nodiscard]] std::optional<BsdfSample> sample(float u_lobe, const V2f& u) const;

    // Fraction of light that goes anywhere but straight through, by tables: approximate.
    [[nodiscard]] Color3f albedo() const;

    // True if next-event estimation has nothing to find: `evaluate` is zero everywhere.
    [[nodiscard]] bool is_delta_only() const;
};

}  // namespace eye_render
