// The population's mean eye: the published numbers, and what lies between them.

#include "optics/population_wavefront.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

TEST(PopulationWavefront, has_the_published_spherical_aberration)
{
    // Thibos et al. 2002, and 0.56 D at the edge of a 6 mm pupil: 24 sqrt(5) c40 / R^2.
    const Wavefront mean = population_wavefront(6e-3);
    EXPECT_EQ(mean.wavelength_nm, 633.0);
    ASSERT_EQ(mean.coefficients_um.size(), 15u);
    EXPECT_NEAR(mean.coefficients_um[12], 0.0942, 1e-12);
    EXPECT_NEAR(24.0 * std::sqrt(5.0) * mean.coefficients_um[12] / 9.0, 0.56, 0.005);
    EXPECT_NEAR(population_wavefront(7.5e-3).coefficients_um[12], 0.1652, 1e-12);
    EXPECT_NEAR(higher_order_rms_um(mean), 0.104, 0.0005);
}

TEST(PopulationWavefront, between_the_measured_pupils_no_coefficient_jumps)
{
    EXPECT_NEAR(population_wavefront(5.25e-3).coefficients_um[12], 0.5 * (0.0304 + 0.0942), 1e-12);
    for (const double pupil_mm : {3.0, 4.5, 6.0}) {
        const Wavefront below = population_wavefront((pupil_mm - 1e-6) * 1e-3);
        const Wavefront above = population_wavefront((pupil_mm + 1e-6) * 1e-3);
        for (std::size_t j = 0; j < 15; ++j) {
            EXPECT_NEAR(below.coefficients_um[j], above.coefficients_um[j], 1e-6)
                << pupil_mm << " mm, index " << j;
        }
    }
}

TEST(PopulationWavefront, below_the_smallest_pupil_is_its_inner_part)
{
    const Wavefront expected = rescaled(population_wavefront(3e-3), 2e-3);
    const Wavefront mean = population_wavefront(2e-3);
    EXPECT_EQ(mean.pupil_diameter_m, 2e-3);
    for (std::size_t j = 0; j < 15; ++j) {
        EXPECT_NEAR(mean.coefficients_um[j], expected.coefficients_um[j], 1e-12) << "index " << j;
    }
}

TEST(PopulationWavefront, left_eye_mirrors_the_right)
{
    const Wavefront right = population_wavefront(6e-3, EyeSide::Right);
    EXPECT_NEAR(right.coefficients_um[8], 0.0017, 1e-12) << "Z(3, 1) of the table";
    const Wavefront left = population_wavefront(6e-3, EyeSide::Left);
    EXPECT_EQ(left.coefficients_um, mirrored(right).coefficients_um);
    EXPECT_NE(left.coefficients_um, right.coefficients_um);
    EXPECT_EQ(population_wavefront(6e-3, EyeSide::Unspecified).coefficients_um,
              right.coefficients_um);
}

TEST(PopulationWavefront, is_refused_beyond_the_study)
{
    EXPECT_THROW(static_cast<void>(population_wavefront(8e-3)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(population_wavefront(0.0)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(population_wavefront(NAN)), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
