// The pupil patterns: the paper's spiral as printed, and the evenly filled disk.

#include "eye/pupil_pattern.h"

#include "base/sobol.h"
#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

double rms_radius(const PupilPattern& pattern, std::uint32_t samples)
{
    double sum = 0.0;
    for (std::uint32_t i = 0; i < samples; ++i) {
        const auto u = sobol_4d(sobol_key(0, 0), i, 0);
        sum += pupil_point(pattern, i, {u[0], u[1]}).length2();
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
            const V2d p = pupil_point(pattern, arm * 4 + ring, {0.9f, 0.1f});
            const double r = ring / 4.0;
            const double phi_rad = 2.0 * pi / 6.0 * (arm + r);
            EXPECT_NEAR(p.x, r * std::cos(phi_rad), 1e-12) << "ring " << ring << ", arm " << arm;
            EXPECT_NEAR(p.y, r * std::sin(phi_rad), 1e-12) << "ring " << ring << ", arm " << arm;
        }
    }
}

TEST(PupilPattern, circinate_is_the_same_in_every_pixel_and_repeats)
{
    const PupilPattern pattern = make_pupil_pattern(PupilPatternKind::Circinate, 16);
    for (std::uint32_t i = 0; i < 16; ++i) {
        EXPECT_EQ(pupil_point(pattern, i, {0.1f, 0.2f}), pupil_point(pattern, i, {0.7f, 0.3f}));
        EXPECT_EQ(pupil_point(pattern, i, {0.0f, 0.0f}),
                  pupil_point(pattern, i + 16, {0.0f, 0.0f}));
    }
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
