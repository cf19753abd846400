// The Stiles-Crawford effect against the vectors and its closed form.

#include "eye/stiles_crawford.h"

#include "../optics_vectors.h"

#include "base/sobol.h"
#include "base/units.h"
#include "base/warp.h"

namespace eye_render {
namespace {

using test::Json;

TEST(StilesCrawford, efficiency_and_effective_area_are_the_vectors)
{
    // Round and centred, where the area is pi (1 - 10^(-rho R^2)) / (rho ln 10).
    for (const Json& vector : test::vectors_of_kind("stiles_crawford")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const double rho = input["rho_log10_per_mm2"];
        const ConeDirectivity round{.rho_x_per_mm2 = rho, .rho_y_per_mm2 = rho};
        const double r_m = m_from_mm(input["r_mm"]);
        test::expect_vector_value(round.efficiency({0.6 * r_m, -0.8 * r_m}),
                                  vector["expect"]["eta"]);
        const double radius_mm = input["pupil_radius_mm"];
        const StilesCrawford pupil(round, m_from_mm(2.0 * radius_mm));
        test::expect_vector_value(pupil.effective_area_ratio() * pi * radius_mm * radius_mm,
                                  vector["expect"]["effective_area_mm2"]);
    }
}

TEST(StilesCrawford, horizontal_and_vertical_differ_as_published)
{
    const ConeDirectivity eye = cone_directivity(EyeSide::Right);
    EXPECT_NEAR(std::log10(eye.efficiency(eye.peak_m + V2d(2e-3, 0.0))), -0.047 * 4.0, 1e-12);
    EXPECT_NEAR(std::log10(eye.efficiency(eye.peak_m + V2d(0.0, 2e-3))), -0.053 * 4.0, 1e-12);
}

TEST(StilesCrawford, peaks_towards_the_nose)
{
    EXPECT_EQ(cone_directivity(EyeSide::Right).peak_m, V2d(-0.51e-3, 0.2e-3));
    EXPECT_EQ(cone_directivity(EyeSide::Left).peak_m, V2d(0.51e-3, 0.2e-3));
    EXPECT_EQ(cone_directivity(EyeSide::Both).peak_m, V2d(0.0, 0.2e-3));
    EXPECT_EQ(cone_directivity(EyeSide::Unspecified).peak_m, V2d(0.0, 0.2e-3));
}

TEST(StilesCrawford, leaves_brightness_alone)
{
    for (const double pupil_mm : {1.5, 4.0, 9.0}) {
        const double radius_m = m_from_mm(0.5 * pupil_mm);
        const StilesCrawford pupil(cone_directivity(EyeSide::Right), 2.0 * radius_m);
        constexpr std::uint32_t samples = 65536;
        double sum = 0.0;
        for (std::uint32_t i = 0; i < samples; ++i) {
            const auto u = sobol_4d(sobol_key(0, 0), i, 0);
            sum += pupil.weight(V2d(sample_uniform_disk({u[0], u[1]})) * radius_m);
        }
        // A smooth integrand converges nearly as 1/samples^1.5.
        EXPECT_NEAR(sum / samples, 1.0, 1e-5) << pupil_mm << " mm";
    }
}

TEST(StilesCrawford, the_smallest_pupil_has_no_apodisation)
{
    const StilesCrawford pupil(cone_directivity(EyeSide::Left), 0.0);
    EXPECT_NEAR(pupil.weight(V2d(0.0)), 1.0, 1e-12);
    EXPECT_NEAR(pupil.effective_area_ratio(), std::pow(10.0, -0.047 * 0.51 * 0.51 - 0.053 * 0.04),
                1e-12);
}

}  // namespace
}  // namespace eye_render
