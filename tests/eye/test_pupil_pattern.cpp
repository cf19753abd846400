// The pupil patterns: the paper's spiral as printed, and the evenly filled disks.

#include "eye/pupil_pattern.h"

#include "../base/chi_squared.h"
#include "base/sobol.h"
#include "base/units.h"
#include "base/warp.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

PupilSample nth_sample(std::uint64_t pixel, std::uint32_t number)
{
    const std::uint64_t key = sobol_key(0, pixel);
    const auto u = sobol_4d(key, number, 0);
    return {.pixel_key = key, .number = number, .u = {u[0], u[1]}};
}

double rms_radius(const PupilPattern& pattern, std::uint32_t samples)
{
    double sum = 0.0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        sum += pupil_point(pattern, nth_sample(0, i)).length2();
    }
    return std::sqrt(sum / samples);
}

TEST(PupilPattern, sobol_fills_the_pupil_evenly)
{
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::Sobol, 4096);
    // The RMS radius of a uniform disk; 4096 stratified samples are well within 1e-3 of it.
    EXPECT_NEAR(rms_radius(pattern, 4096), std::sqrt(0.5), 1e-3);
}

TEST(PupilPattern, circinate_has_the_rms_radius_of_its_printed_rings)
{
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::Circinate, 64);
    EXPECT_EQ(pattern.distant_factor, 8u);
    EXPECT_EQ(pattern.angle_factor, 8u);
    // sqrt((N - 1)(2N - 1) / 6N^2) for N = 8 rings.
    EXPECT_NEAR(rms_radius(pattern, 64), std::sqrt(7.0 * 15.0 / (6.0 * 64.0)), 1e-12);
}

TEST(PupilPattern, circinate_follows_equations_9_to_13)
{
    const PupilPattern pattern{
        .kind = PupilPatternKind::Circinate, .distant_factor = 4, .angle_factor = 6};
    for (std::uint32_t arm = 0; arm < 6; ++arm) {
        for (std::uint32_t ring = 0; ring < 4; ++ring) {
            const V2d p = pupil_point(pattern, nth_sample(3, arm * 4 + ring));
            const double r = ring / 4.0;
            const double phi_rad = 2.0 * pi / 6.0 * (arm + r);
            EXPECT_NEAR(p.x, r * std::cos(phi_rad), 1e-12) << "ring " << ring << ", arm " << arm;
            EXPECT_NEAR(p.y, r * std::sin(phi_rad), 1e-12) << "ring " << ring << ", arm " << arm;
        }
    }
}

TEST(PupilPattern, circinate_and_grid_are_the_same_in_every_pixel_and_repeat)
{
    for (const PupilPatternKind kind : {PupilPatternKind::Circinate, PupilPatternKind::Grid}) {
        const PupilPattern pattern = make_pupil_pattern(kind, 16);
        for (std::uint32_t i = 0; i < 16; ++i) {
            const V2d p = pupil_point(pattern, nth_sample(0, i));
            EXPECT_EQ(p, pupil_point(pattern, nth_sample(1, i)));
            EXPECT_EQ(p, pupil_point(pattern, nth_sample(0, i + 16)));
        }
    }
}

TEST(PupilPattern, sobol_and_random_differ_between_pixels)
{
    for (const PupilPatternKind kind :
         {PupilPatternKind::Sobol, PupilPatternKind::UniformRandom}) {
        const PupilPattern pattern = make_pupil_pattern(kind, 16);
        for (std::uint32_t i = 0; i < 16; ++i) {
            EXPECT_NE(pupil_point(pattern, nth_sample(0, i)),
                      pupil_point(pattern, nth_sample(1, i)));
        }
    }
}

TEST(PupilPattern, random_fills_the_pupil_evenly_and_independently)
{
    // Chi-squared over cells of equal area, across samples and across pixels.
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::UniformRandom, 4096);
    constexpr std::uint32_t side = 16;
    constexpr std::uint32_t samples = 1u << 18;
    for (const bool across_pixels : {false, true}) {
        std::vector<double> observed(side * side, 0.0);
        for (std::uint32_t i = 0; i < samples; ++i) {
            const V2f square = invert_uniform_disk(
                V2f(pupil_point(pattern, across_pixels ? nth_sample(i, 0) : nth_sample(0, i))));
            const auto x = static_cast<std::size_t>(square.x * side);
            const auto y = static_cast<std::size_t>(square.y * side);
            ++observed[std::min<std::size_t>(y, side - 1) * side +
                       std::min<std::size_t>(x, side - 1)];
        }
        const std::vector<double> expected(side * side, double(samples) / (side * side));
        const test::ChiSquared test = test::chi_squared_test(observed, expected, 0.005);
        EXPECT_LT(test.statistic, test.critical) << (across_pixels ? "pixels" : "samples");
        // Stratified points would be too even to be independent.
        EXPECT_GT(test.statistic, 0.6 * (side * side)) << (across_pixels ? "pixels" : "samples");
    }
}

TEST(PupilPattern, random_owes_nothing_to_the_sobol_points)
{
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::UniformRandom, 16);
    PupilSample sample = nth_sample(5, 7);
    const V2d p = pupil_point(pattern, sample);
    sample.u = {0.25f, 0.75f};
    EXPECT_EQ(pupil_point(pattern, sample), p);
    // No correlation with their angle or radius: r of 65536 pairs has a deviation of 0.004.
    const PupilPattern sobol = make_pupil_pattern(PupilPatternKind::Sobol, 16);
    constexpr std::uint32_t samples = 65536;
    V2d product(0.0);
    for (std::uint32_t i = 0; i < samples; ++i) {
        const PupilSample pixel = nth_sample(i, 3);
        product += pupil_point(pattern, pixel) * pupil_point(sobol, pixel);
    }
    EXPECT_NEAR(product.x / samples, 0.0, 0.25 * 0.016);  // variance of x and y: 1/4
    EXPECT_NEAR(product.y / samples, 0.0, 0.25 * 0.016);
}

TEST(PupilPattern, grid_has_one_point_in_each_of_its_equal_cells)
{
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::Grid, 20);
    EXPECT_EQ(pattern.distant_factor, 4u);
    EXPECT_EQ(pattern.angle_factor, 5u);
    for (std::uint32_t i = 0; i < 20; ++i) {
        const V2f square = invert_uniform_disk(V2f(pupil_point(pattern, nth_sample(0, i))));
        EXPECT_NEAR(square.x, (double(i % 4) + 0.5) / 4.0, 1e-6) << i;
        EXPECT_NEAR(square.y, (double(i / 4) + 0.5) / 5.0, 1e-6) << i;
    }
}

TEST(PupilPattern, grid_fills_the_pupil)
{
    // The RMS radius of a uniform disk; a grid's error falls as 1/samples.
    EXPECT_NEAR(rms_radius(make_pupil_pattern(PupilPatternKind::Grid, 4096), 4096), std::sqrt(0.5),
                1e-3);
}

TEST(PupilPattern, circinate_has_a_point_for_every_sample)
{
    for (std::uint32_t samples = 1; samples <= 300; ++samples) {
        const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::Circinate, samples);
        const std::uint32_t points = pattern.distant_factor * pattern.angle_factor;
        EXPECT_GE(points, samples);
        EXPECT_LT(points, samples + pattern.distant_factor);
    }
}

}  // namespace
}  // namespace eye_render
