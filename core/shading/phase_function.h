// How a medium scatters: Draine's phase function of the angle between the directions of travel
// before and after (Draine 2003, "Scattering by Interstellar Dust Grains. I", eq. 9). Without
// `alpha` it is Henyey and Greenstein's (1941), with g = 0 and alpha = 1 Rayleigh's. Or that of
// particles in water.
//
// Angles are told by 1 - cos, 0 where light goes straight on and 2 where it turns back: a cosine
// near 1 has no digits left for a peak as narrow as g = 0.999. Peaks straight back have those of a
// cosine: g = -0.999 is off by a tenth at its middle. Probabilities are per unit solid angle.

#pragma once

#include "base/vector.h"
#include "shading/fournier_forand.h"

#include <optional>

#include <algorithm>

namespace eye_render {

struct PhaseFunction {
    float g = 0.0f;  // anisotropy, within +-largest_anisotropy
    float alpha = 0.0f;
    std::optional<FournierForand> particles{};  // in place of Draine's

    bool operator==(const PhaseFunction&) const = default;
};

inline constexpr float largest_anisotropy = 0.999f;

// 1 - cos of the angle between two unit directions.
[[nodiscard]] inline float one_minus_cosine(const V3f& a, const V3f& b)
{
    return std::min(0.5f * (a - b).length2(), 2.0f);
}

// The share of light per unit solid angle: integrates to 1 over the sphere.
[[nodiscard]] float phase_value(const PhaseFunction& phase, float one_minus_cos);

// Draws a direction of travel for light that came along `direction`, u in [0, 1)^2. The density is
// that of Henyey and Greenstein's factor, so that value over density is at most 1 + alpha; of
// particles their own.
[[nodiscard]] V3f sample_phase(const PhaseFunction& phase, const V3f& direction, const V2f& u);
[[nodiscard]] float phase_pdf(const PhaseFunction& phase, float one_minus_cos);

}  // namespace eye_render
