#include "shading/fournier_forand.h"

#include "shading/input_range.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr double pi = std::numbers::pi;

// Of sin^2(theta / 2), for the density to be finite.
constexpr double least_half_sine2 = 0.25e-12;

// Where delta is this close to 1 the formulas are quotients of next to nothing, and the first two
// terms of their series are closer: both err by 1e-8 there.
constexpr double near_one = 1e-4;

// What value and share have in common at an angle.
struct Angle {
    double half_sine2;  // sin^2(theta / 2)
    double cosine;
    double rest;   // 1 - delta
    double power;  // delta^v

    Angle(const FournierForand& particles, double half_sine_squared)
        : half_sine2(half_sine_squared), cosine(1.0 - 2.0 * half_sine_squared),
          rest(1.0 - particles.delta_behind * half_sine_squared),
          power(std::pow(1.0 - rest, particles.exponent))
    {
    }
};

[[nodiscard]] double value_at(const FournierForand& particles, const Angle& at)
{
    const double v = particles.exponent;
    const double rebound = particles.rebound / (16.0 * pi) * (3.0 * at.cosine * at.cosine - 1.0);
    if (std::abs(at.rest) < near_one) {
        return v * ((v - 1.0) - (v + 1.0) / at.half_sine2) / (8.0 * pi) +
               v * (v + 1.0) * at.rest * (2.0 * (v - 1.0) - (2.0 * v + 1.0) / at.half_sine2) /
                   (24.0 * pi) +
               rebound;
    }
    const double ahead = ((1.0 - at.rest) * (1.0 - at.power) - v * at.rest) / at.half_sine2;
    return (v * at.rest - (1.0 - at.power) + ahead) / (4.0 * pi * at.rest * at.rest * at.power) +
           rebound;
}

// Of the light that turns by less.
[[nodiscard]] double share_at(const FournierForand& particles, const Angle& at)
{
    const double v = particles.exponent;
    const double rebound = particles.rebound / 8.0 * at.cosine * (1.0 - at.cosine * at.cosine);
    if (std::abs(at.rest) < near_one) {
        return 1.0 + v * (1.0 - at.half_sine2) * (1.0 - 0.5 * (v + 1.0) * at.rest) + rebound;
    }
    return (1.0 - at.power * (1.0 - at.rest) - (1.0 - at.power) * at.half_sine2) /
               (at.rest * at.power) +
           rebound;
}

}  // namespace

FournierForand fournier_forand(float ior, float backscatter)
{
    // Without backscatter all light would go straight on; half of it is the most.
    const auto share = static_cast<double>(in_range(std::abs(backscatter), 1e-4f, 0.499f));
    const auto excess = static_cast<double>(in_range(ior, 1.001f, largest_ior)) - 1.0;
    const double behind = 4.0 / (3.0 * excess * excess);
    const double across = 0.5 * behind;  // delta at 90 degrees
    // A quotient of logarithms that are both 0 where delta is 1 at 90 degrees.
    const double v = std::abs(across - 1.0) < 1e-6
                         ? -2.0 * share
                         : -std::log1p(2.0 * share * (across - 1.0)) / std::log(across);
    // Likewise where it is 1 straight behind.
    const double rebound =
        std::abs(behind - 1.0) < 1e-6 ? -v : (std::pow(behind, -v) - 1.0) / (behind - 1.0);
    return {.delta_behind = behind, .exponent = v, .rebound = rebound};
}

float fournier_forand_pdf(const FournierForand& particles, float one_minus_cos)
{
    const double half_sine2 =
        std::clamp(0.5 * static_cast<double>(one_minus_cos), least_half_sine2, 1.0);
    return static_cast<float>(std::max(0.0, value_at(particles, Angle(particles, half_sine2))));
}

double sample_fournier_forand(const FournierForand& particles, double u)
{
    // Newton's steps in the logarithm, in which the share is smooth; bisection where they leave
    // what is left of the interval.
    constexpr double tolerance = 1e-7;
    constexpr int most_steps = 60;
    double low = std::log(least_half_sine2);
    double high = 0.0;
    double x = -3.0;
    for (int step = 0; step < most_steps; ++step) {
        const Angle at(particles, std::exp(x));
        const double excess = share_at(particles, at) - u;
        (excess > 0.0 ? high : low) = x;
        const double slope = 4.0 * pi * at.half_sine2 * value_at(particles, at);
        double next = x - excess / slope;
        if (!(next > low && next < high)) {
            next = 0.5 * (low + high);
        }
        if (std::abs(next - x) < tolerance) {
            return std::exp(next);
        }
        x = next;
    }
    return std::exp(x);
}

}  // namespace eye_render
