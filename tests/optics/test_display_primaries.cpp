// The display's spectra: their sums, their samples, and what a dispersed white adds up to.

#include "optics/display_primaries.h"

#include "../base/chi_squared.h"
#include "base/sobol.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

TEST(DisplayPrimaries, each_holds_the_light_of_its_channel)
{
    constexpr int steps = 300000;
    V3d total(0.0);
    double density = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double nm = 400.0 + 300.0 * (i + 0.5) / steps;
        const V3d weights = display_primaries(nm, WorkingSpace::Rec709);
        ASSERT_GE(std::min(weights.x, std::min(weights.y, weights.z)), 0.0) << nm;
        total += weights * (300.0 / steps);
        density += wavelength_pdf(nm, WorkingSpace::Rec709) * (300.0 / steps);
    }
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(total[channel], 1.0, 1e-9) << "channel " << channel;
    }
    EXPECT_NEAR(density, 1.0, 1e-9);
}

TEST(DisplayPrimaries, lie_where_the_colours_are)
{
    const V3d violet_blue = display_primaries(450.0, WorkingSpace::Rec709);
    const V3d green = display_primaries(540.0, WorkingSpace::Rec709);
    const V3d red = display_primaries(620.0, WorkingSpace::Rec709);
    EXPECT_GT(violet_blue.z, 10.0 * std::max(violet_blue.x, violet_blue.y));
    EXPECT_GT(green.y, 10.0 * std::max(green.x, green.z));
    EXPECT_GT(red.x, 10.0 * std::max(red.y, red.z));
    // No red in what is bluer than the blue-green: the matching function is negative there.
    EXPECT_EQ(display_primaries(500.0, WorkingSpace::Rec709).x, 0.0);
    EXPECT_EQ(display_primaries(399.9, WorkingSpace::Rec709), V3d(0.0));
    EXPECT_EQ(display_primaries(700.1, WorkingSpace::Rec709), V3d(0.0));
}

TEST(SampleWavelength, inverts_and_is_inverted)
{
    for (int i = 0; i < 10000; ++i) {
        const double u = (i + 0.5) / 10000.0;
        const double nm = sample_wavelength_nm(u, WorkingSpace::Rec709);
        ASSERT_NEAR(invert_wavelength(nm, WorkingSpace::Rec709), u, 1e-12) << u;
    }
    EXPECT_EQ(sample_wavelength_nm(0.0, WorkingSpace::Rec709), 400.0);
    EXPECT_LE(sample_wavelength_nm(std::nextafter(1.0, 0.0), WorkingSpace::Rec709), 700.0);
    EXPECT_NEAR(invert_wavelength(700.0, WorkingSpace::Rec709), 1.0, 1e-12);
}

TEST(SampleWavelength, samples_follow_their_density)
{
    constexpr std::size_t cells = 100;
    constexpr std::size_t samples = 1000000;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform;
    std::vector<double> observed(cells, 0.0);
    std::vector<double> expected(cells, 0.0);
    for (std::size_t i = 0; i < samples; ++i) {
        const double nm = sample_wavelength_nm(uniform(random), WorkingSpace::Rec709);
        ++observed[std::min(static_cast<std::size_t>((nm - 400.0) / 3.0), cells - 1)];
    }
    for (std::size_t cell = 0; cell < cells; ++cell) {
        // The midpoint of each nanometre, in which the density is a straight line.
        for (int nm = 0; nm < 3; ++nm) {
            const double left = 400.0 + 3.0 * static_cast<double>(cell) + nm;
            expected[cell] += samples * wavelength_pdf(left + 0.5, WorkingSpace::Rec709);
        }
    }
    const test::ChiSquared test = test::chi_squared_test(observed, expected, 0.01);
    EXPECT_LT(test.statistic, test.critical);
}

TEST(SampleWavelength, white_stays_white)
{
    // Mean of weight over density, by 4096 stratified samples of a bounded integrand.
    constexpr std::uint32_t samples = 4096;
    V3d sum(0.0);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const double nm =
            sample_wavelength_nm(sobol_4d(sobol_key(0, 0), i, 0)[0], WorkingSpace::Rec709);
        const V3d ratio =
            display_primaries(nm, WorkingSpace::Rec709) / wavelength_pdf(nm, WorkingSpace::Rec709);
        ASSERT_LE(std::max(ratio.x, std::max(ratio.y, ratio.z)), 3.0 + 1e-12) << nm;
        sum += ratio;
    }
    for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(sum[channel] / samples, 1.0, 1e-3) << "channel " << channel;
    }
}

}  // namespace
}  // namespace eye_render
