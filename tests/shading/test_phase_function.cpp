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
            const auto turned = static_cast<float>(1.0 - std::cos(theta));
            value += double(phase_value(phase, turned)) * ring;
            pdf += double(phase_pdf(phase, turned)) * ring;
            mean_cosine += double(phase_value(phase, turned)) * ring * std::cos(theta);
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
                    count * solid_angle * double(phase_pdf(phase, one_minus_cosine(direction, w)));
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

// Against the same in double, for directions that are as float has them.
TEST(PhaseFunction, density_of_a_narrow_peak_keeps_its_digits)
{
    for (const float g : {0.9f, 0.99f, largest_anisotropy, -0.95f}) {
        const PhaseFunction phase{.g = g};
        const std::uint64_t key = sobol_key(5, 0);
        for (std::uint32_t i = 0; i < 4096; ++i) {
            const auto u = sobol_4d(key, i, 0);
            const V3f direction = test::direction_at(70.0 + u[2], 200.0 + u[3]);
            const V3f w = sample_phase(phase, direction, V2f(u[0], u[1]));
            const double turned =
                0.5 * (V3d(w).normalized() - V3d(direction).normalized()).length2();
            const double d = std::pow(1.0 - double(g), 2) + 2.0 * double(g) * turned;
            const double expected = (1.0 - double(g) * double(g)) / (4.0 * pi * std::pow(d, 1.5));
            ASSERT_NEAR(double(phase_pdf(phase, one_minus_cosine(direction, w))) / expected, 1.0,
                        2e-3)
                << g << ", " << u[0];
        }
    }
    for (const float g : {largest_anisotropy, -largest_anisotropy}) {
        const V3f longer(0.0f, 0.0f, 1.0f + 4e-7f);  // than a unit, by rounding
        EXPECT_TRUE(std::isfinite(phase_pdf({.g = g}, one_minus_cosine(longer, longer))));
        EXPECT_TRUE(std::isfinite(phase_pdf({.g = g}, one_minus_cosine(longer, -longer))));
    }
}

// Against the cumulative distribution in double: half of the light of g = 0.999 turns by less
// than a fifth of a degree.
TEST(PhaseFunction, angles_of_a_narrow_peak_are_drawn_by_their_distribution)
{
    const V3f direction = test::direction_at(70.0, 200.0);
    for (const float g : {1e-4f, 0.99f, largest_anisotropy, -0.95f}) {
        for (const float u : {0.01f, 0.25f, 0.5f, 0.9f}) {
            const V3f w = sample_phase({.g = g}, direction, V2f(u, 0.3f));
            const double turned =
                0.5 * (V3d(w).normalized() - V3d(direction).normalized()).length2();
            const double gd = g;
            const double chord = std::sqrt(std::pow(1.0 - gd, 2) + 2.0 * gd * turned);
            // Of the cone around the direction.
            const double share = (1.0 - gd * gd) / (2.0 * gd) * (1.0 / (1.0 - gd) - 1.0 / chord);
            EXPECT_NEAR(share / double(u), 1.0, 5e-3) << g << ", " << u;
        }
    }
}

TEST(PhaseFunction, rayleighs_is_a_case_of_draines)
{
    for (const float cosine : {-1.0f, -0.3f, 0.0f, 0.8f}) {
        EXPECT_NEAR(phase_value({.alpha = 1.0f}, 1.0f - cosine),
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
                return phase_value(d.narrow, 1.0f - cosine) * (1.0f - d.wide_share) +
                       phase_value(d.wide, 1.0f - cosine) * d.wide_share;
            };
            EXPECT_NEAR(value(below) / value(above), 1.0f, 0.3f) << diameter_um << ", " << cosine;
        }
    }
}

}  // namespace
}  // namespace eye_render
