#include "shading/phase_function.h"

#include "shading/frame.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float inverse_four_pi = 0.25f * std::numbers::inv_pi_v<float>;

// Below this the inverse divides by nearly nothing, and the cosine differs from that of even
// scattering by less than 2 |g|.
constexpr float least_anisotropy = 1e-3f;

// The inverse of the cumulative distribution of Henyey and Greenstein's cosine.
[[nodiscard]] float sample_cosine(float g, float u)
{
    if (std::abs(g) < least_anisotropy) {
        return 1.0f - 2.0f * u;
    }
    const float s = (1.0f - g * g) / (1.0f + g - 2.0f * g * u);
    return std::clamp((1.0f + g * g - s * s) / (2.0f * g), -1.0f, 1.0f);
}

}  // namespace

float phase_pdf(const PhaseFunction& phase, float cosine)
{
    const float g = std::abs(phase.g) < least_anisotropy ? 0.0f : phase.g;
    const float d = 1.0f + g * g - 2.0f * g * cosine;
    return inverse_four_pi * (1.0f - g * g) / (d * std::sqrt(d));
}

float phase_value(const PhaseFunction& phase, float cosine)
{
    const float g2 = phase.g * phase.g;
    return phase_pdf(phase, cosine) * (1.0f + phase.alpha * cosine * cosine) /
           (1.0f + phase.alpha * (1.0f + 2.0f * g2) / 3.0f);
}

V3f sample_phase(const PhaseFunction& phase, const V3f& direction, const V2f& u)
{
    const float cosine = sample_cosine(phase.g, u.x);
    const float sine = std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    const float azimuth = 2.0f * std::numbers::pi_v<float> * u.y;
    return Frame(direction).world_from_local(
        {sine * std::cos(azimuth), sine * std::sin(azimuth), cosine});
}

}  // namespace eye_render
