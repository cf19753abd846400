#include "shading/fibre_spread.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi_f = std::numbers::pi_v<float>;

// exp(-x) I0(x): Abramowitz & Stegun 1964, 9.8.1 and 9.8.2, to 2e-7.
[[nodiscard]] float scaled_bessel_i0(float x)
{
    constexpr float border = 3.75f;
    if (x < border) {
        const float t = x * x / (border * border);
        return std::exp(-x) *
               (1.0f + t * (3.5156229f +
                            t * (3.0899424f +
                                 t * (1.2067492f +
                                      t * (0.2659732f + t * (0.0360768f + t * 0.0045813f))))));
    }
    const float t = border / x;
    const float tail =
        t * (0.00916281f +
             t * (-0.02057706f + t * (0.02635537f + t * (-0.01647633f + t * 0.00392377f))));
    return (0.39894228f + t * (0.01328592f + t * (0.00225319f + t * (-0.00157565f + tail)))) /
           std::sqrt(x);
}

// Share of the logistic distribution below -pi.
[[nodiscard]] float logistic_tail(float scale) { return 1.0f / (1.0f + std::exp(pi_f / scale)); }

}  // namespace

Elevation Elevation::of_sine(float sine)
{
    const float s = std::clamp(sine, -1.0f, 1.0f);
    return {s, std::sqrt(1.0f - s * s)};
}

Elevation Elevation::turned(float angle_rad) const
{
    const float s = std::sin(angle_rad);
    const float c = std::cos(angle_rad);
    return {sine * c + cosine * s, std::abs(cosine * c - sine * s)};
}

float along_density(const Elevation& i, const Elevation& o, float variance)
{
    // What cancels between the exponentials is taken out of them, so that narrow lobes keep their
    // digits.
    const float bessel = scaled_bessel_i0(i.cosine * o.cosine / variance);
    const float dc = i.cosine - o.cosine;
    const float ds = i.sine + o.sine;
    return bessel * std::exp(-0.5f * (dc * dc + ds * ds) / variance) /
           (variance * -std::expm1(-2.0f / variance));
}

Elevation sample_along(float u_drop, float u_turn, const Elevation& o, float variance)
{
    // 1 less the cosine from the mirror direction.
    constexpr float least_u = 1e-5f;  // which has a logarithm where the exponential is 0
    const float u = std::max(u_drop, least_u);
    const float drop =
        std::clamp(-variance * std::log(u + (1.0f - u) * std::exp(-2.0f / variance)), 0.0f, 2.0f);
    return Elevation::of_sine((drop - 1.0f) * o.sine + std::sqrt(drop * (2.0f - drop)) *
                                                           std::cos(2.0f * pi_f * u_turn) *
                                                           o.cosine);
}

float around_density(float phi, float scale)
{
    const float wrapped = phi - 2.0f * pi_f * std::floor(phi / (2.0f * pi_f) + 0.5f);
    const float e = std::exp(-std::abs(wrapped) / scale);
    return e / (scale * (1.0f + e) * (1.0f + e) * (1.0f - 2.0f * logistic_tail(scale)));
}

float sample_around(float u, float scale)
{
    const float tail = logistic_tail(scale);
    const float below = u * (1.0f - 2.0f * tail) + tail;
    return std::clamp(-scale * std::log(1.0f / below - 1.0f), -pi_f, pi_f);
}

}  // namespace eye_render
