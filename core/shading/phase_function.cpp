#include "shading/phase_function.h"

#include "shading/frame.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float inverse_four_pi = 0.25f * std::numbers::inv_pi_v<float>;

// 1 - cos by the inverse of Henyey and Greenstein's cumulative distribution, without its quotient
// by g and its differences of numbers that are nearly the same: u goes from 0, straight on, to 1.
[[nodiscard]] float sample_one_minus_cos(float g, float u)
{
    const float away = 1.0f - g;
    const float q = away + 2.0f * g * (1.0f - u);
    return std::clamp(2.0f * away * away * u * (1.0f + g * (1.0f - u)) / (q * q), 0.0f, 2.0f);
}

[[nodiscard]] float sample_one_minus_cos(const PhaseFunction& phase, float u)
{
    return phase.particles
               ? static_cast<float>(
                     2.0 * sample_fournier_forand(*phase.particles, static_cast<double>(u)))
               : sample_one_minus_cos(phase.g, u);
}

}  // namespace

float phase_pdf(const PhaseFunction& phase, float one_minus_cos)
{
    if (phase.particles) {
        return fournier_forand_pdf(*phase.particles, one_minus_cos);
    }
    const float away = 1.0f - phase.g;
    const float d = away * away + 2.0f * phase.g * one_minus_cos;
    return inverse_four_pi * away * (1.0f + phase.g) / (d * std::sqrt(d));
}

float phase_value(const PhaseFunction& phase, float one_minus_cos)
{
    if (phase.particles) {
        return fournier_forand_pdf(*phase.particles, one_minus_cos);
    }
    const float g2 = phase.g * phase.g;
    const float cosine = 1.0f - one_minus_cos;
    return phase_pdf(phase, one_minus_cos) * (1.0f + phase.alpha * cosine * cosine) /
           (1.0f + phase.alpha * (1.0f + 2.0f * g2) / 3.0f);
}

V3f sample_phase(const PhaseFunction& phase, const V3f& direction, const V2f& u)
{
    const float turned = sample_one_minus_cos(phase, u.x);
    const float sine = std::sqrt(turned * (2.0f - turned));
    const float azimuth = 2.0f * std::numbers::pi_v<float> * u.y;
    return Frame(direction)
        .world_from_local({sine * std::cos(azimuth), sine * std::sin(azimuth), 1.0f - turned})
        .normalized();
}

}  // namespace eye_render
