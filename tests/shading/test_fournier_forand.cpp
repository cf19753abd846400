// Fournier and Forand's phase function: its shares are what it was asked for, and its samples are
// spread as its density says.

#include "shading/fournier_forand.h"

#include "../base/chi_squared.h"
#include "base/units.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace eye_render {
namespace {

struct Water {
    float ior;
    float backscatter;
};

// The third has delta 1 at 90 degrees, the fourth straight behind.
const std::vector<Water> waters{{1.33f, 0.1f},
                                {1.05f, 0.01f},
                                {1.8164966f, 0.2f},
                                {2.1547005f, 0.3f},
                                {1.1f, 0.4f}};

// Of light that turns by an angle with sin^2(theta / 2) between the two; in its logarithm, in
// which the density is smooth.
double share_between(const FournierForand& particles, double low, double high)
{
    constexpr int steps = 2000;
    double sum = 0.0;
    const double width = std::log(high / low) / steps;
    for (int i = 0; i < steps; ++i) {
        const double t = low * std::exp((i + 0.5) * width);
        sum += 4.0 * pi * double(fournier_forand_pdf(particles, float(2.0 * t))) * t * width;
    }
    return sum;
}

TEST(FournierForand, scatters_as_much_backwards_as_it_was_asked)
{
    for (const Water& water : waters) {
        const FournierForand particles = fournier_forand(water.ior, water.backscatter);
        EXPECT_NEAR(share_between(particles, 0.5, 1.0), double(water.backscatter), 2e-4)
            << water.ior;
        EXPECT_NEAR(sample_fournier_forand(particles, 1.0 - double(water.backscatter)), 0.5, 1e-4)
            << water.ior;
    }
}

TEST(FournierForand, shares_are_integrals_of_the_density)
{
    for (const Water& water : waters) {
        const FournierForand particles = fournier_forand(water.ior, water.backscatter);
        for (const double u : {0.3, 0.6, 0.9, 0.99}) {
            const double t = sample_fournier_forand(particles, u);
            EXPECT_NEAR(share_between(particles, t, 1.0), 1.0 - u, 1e-3) << water.ior << ", " << u;
        }
    }
}

TEST(FournierForand, samples_are_spread_as_the_density_says)
{
    constexpr int bins = 100;
    constexpr int samples = 300000;
    constexpr double least = 1e-7;
    const double significance = 1.0 - std::pow(0.99, 1.0 / double(waters.size()));
    for (const Water& water : waters) {
        const FournierForand particles = fournier_forand(water.ior, water.backscatter);
        std::vector<double> expected(bins + 1), observed(bins + 1);
        expected[bins] = samples;
        for (int i = 0; i < bins; ++i) {
            const double low = std::pow(least, 1.0 - double(i) / bins);
            const double high = std::pow(least, 1.0 - double(i + 1) / bins);
            expected[std::size_t(i)] = samples * share_between(particles, low, high);
            expected[bins] -= expected[std::size_t(i)];
        }
        std::mt19937 generator(5);
        std::uniform_real_distribution<double> uniform(0.0, 1.0);
        for (int i = 0; i < samples; ++i) {
            const double t = sample_fournier_forand(particles, uniform(generator));
            const double place = (1.0 - std::log(t) / std::log(least)) * bins;
            ++observed[std::size_t(place < 0.0 ? bins : std::min(int(place), bins - 1))];
        }
        const test::ChiSquared fit = test::chi_squared_test(observed, expected, significance);
        EXPECT_LT(fit.statistic, fit.critical) << water.ior << ", " << water.backscatter;
    }
}

TEST(FournierForand, is_finite_whatever_it_is_asked)
{
    for (const float ior : {-1.0f, 0.0f, 1.0f, 1000.0f, INFINITY, NAN}) {
        for (const float backscatter : {-0.2f, 0.0f, 0.5f, 2.0f, NAN}) {
            const FournierForand particles = fournier_forand(ior, backscatter);
            for (const float one_minus_cos : {2.0f, 1.0f, 0.5f, 0.0f}) {
                EXPECT_TRUE(std::isfinite(fournier_forand_pdf(particles, one_minus_cos)))
                    << ior << ", " << backscatter << ", " << one_minus_cos;
            }
            for (const double u : {0.0, 1e-9, 0.5, 0.9999999}) {
                const double t = sample_fournier_forand(particles, u);
                EXPECT_TRUE(t > 0.0 && t <= 1.0) << ior << ", " << backscatter << ", " << u;
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
