// Phase functions: what goes where adds up to all, and samples are spread as their density says.

#include "shading/phase_function.h"

#include "../base/chi_squared.h"
#include "base/sobol.h"
#include "scattering.h"
#include "shading/droplets.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

std::vector<PhaseFunction> phases()
{
    std::vector<PhaseFunction> all{{},
                                   {.g = 1e-4f},
                                   {.g = 0.3f},
                                   {.g = -0.7f},
                                   {.g = 0.95f},
                                   {.alpha = 1.0f},
                                   {.g = 0.5f, .alpha = 30.0f}};
    for (const float diameter_um : {0.05f, 1.0f, 3.0f, 20.0f, 90.0f}) {
        const DropletScattering droplets = scattering_of_droplets(diameter_um);
        all.push_back(droplets.narrow);
        all.push_back(droplets.wide);
    }
    return all;
}

TEST(PhaseFunction, scatters_all_of_the_light_and_not_more)
{
    for (const PhaseFunction& phase : phases()) {
        double value = 0.0;
        double pdf = 0.0;
        double mean_cosine = 0.0;
        // Fine near the pole, where the narrowest are a hundredth of a radian wide.
        constexpr int steps = 200000;
        for (int i = 0; i < steps; ++i) {
            const double theta = (i + 0.5) * pi / steps;
            const double ring = 2.0 * pi * std::sin(theta) * pi / steps;
            const auto cosine = static_cast<float>(std::cos(theta));
            value += double(phase_value(phase, cosine)) * ring;
            pdf += double(phase_pdf(phase, cosine)) * ring;
            mean_cosine += double(phase_value(phase, cosine)) * ring * std::cos(theta);
        }
        EXPECT_NEAR(value, 1.0, 2e-3) << phase.g << ", " << phase.alpha;
        EXPECT_NEAR(pdf, 1.0, 2e-3) << phase.g << ", " << phase.alpha;
        if (phase.alpha == 0.0f) {
            EXPECT_NEAR(mean_cosine, double(phase.g), 2e-3);  // Henyey and Greenstein's g
        }
    }
}

TEST(PhaseFunction, samples_are_spread_as_the_density_says)
{
    constexpr int heights = 64;
    constexpr int azimuths = 16;
    constexpr int count = 1 << 20;
    const V3f direction = test::direction_at(70.0, 200.0);
    for (const PhaseFunction& phase : phases()) {
        if (phase.g > 0.97f) {
            continue;  // narrower than the grid that counts what is expected
        }
        std::vector<double> expected(heights * azimuths, 0.0);
        // The cells' own shares, each by a grid of its own, because lobes may be narrower.
        constexpr int finer = 16;
        test::for_each_direction(
            heights * finer, azimuths * finer, [&](const V3f& w, double solid_angle) {
                expected[test::cell_of(w, heights, azimuths)] +=
                    count * solid_angle * double(phase_pdf(phase, direction.dot(w)));
            });
        std::vector<double> observed(heights * azimuths, 0.0);
        const std::uint64_t key = sobol_key(3, 0);
        for (std::uint32_t i = 0; i < count; ++i) {
            const auto u = sobol_4d(key, i, 0);
            const V3f w = sample_phase(phase, direction, V2f(u[0], u[1]));
            EXPECT_NEAR(w.length(), 1.0f, 1e-5f);
            observed[test::cell_of(w, heights, azimuths)] += 1.0;
        }
        // Sobol's points are spread better than random ones, so only too large is wrong. Sidak for
        // as many phase functions.
        const auto trials = static_cast<double>(phases().size());
        const auto chi =
            test::chi_squared_test(observed, expected, 1.0 - std::pow(0.99, 1.0 / trials));
        EXPECT_LT(chi.statistic, chi.critical) << phase.g << ", " << phase.alpha;
    }
}

TEST(PhaseFunction, rayleighs_is_a_case_of_draines)
{
    for (const float cosine : {-1.0f, -0.3f, 0.0f, 0.8f}) {
        EXPECT_NEAR(phase_value({.alpha = 1.0f}, cosine),
                    3.0 / (16.0 * pi) * (1.0 + double(cosine * cosine)), 1e-6);
    }
}

// Jendersie and d'Eon 2023, figure 1: a narrow peak ahead, and a wide part.
TEST(PhaseFunction, larger_droplets_scatter_more_straight_ahead)
{
    float last = 0.0f;
    for (const float diameter_um : {6.0f, 10.0f, 20.0f, 40.0f}) {
        const DropletScattering droplets = scattering_of_droplets(diameter_um);
        EXPECT_GT(droplets.narrow.g, last);
        EXPECT_GT(droplets.wide_share, 0.3f);
        EXPECT_LT(droplets.wide_share, 0.52f);
        last = droplets.narrow.g;
    }
    // The four fits meet where one takes over from the next.
    for (const float diameter_um : {0.1f, 1.5f, 5.0f}) {
        const DropletScattering below = scattering_of_droplets(diameter_um * 0.9999f);
        const DropletScattering above = scattering_of_droplets(diameter_um * 1.0001f);
        for (const float cosine : {-1.0f, 0.0f, 0.9f}) {
            const auto value = [cosine](const DropletScattering& d) {
                return phase_value(d.narrow, cosine) * (1.0f - d.wide_share) +
                       phase_value(d.wide, cosine) * d.wide_share;
            };
            EXPECT_NEAR(value(below) / value(above), 1.0f, 0.3f) << diameter_um << ", " << cosine;
        }
    }
}

}  // namespace
}  // namespace eye_render
