// Diffraction's closed forms, against the vectors and against an integral.

#include "analysis/diffraction.h"

#include "../optics_vectors.h"

#include "base/units.h"
#include "eye/eye_factory.h"

namespace eye_render {
namespace {

TEST(Diffraction, limits_are_the_vectors)
{
    for (const test::Json& vector : test::vectors_of_kind("diffraction")) {
        EYE_TRACE_VECTOR(vector);
        const double pupil_m = m_from_mm(vector["input"]["pupil_mm"]);
        const double wavelength_nm = vector["input"]["lambda_nm"];
        const test::Json& expected = vector["expect"];
        test::expect_vector_value(arcmin_from_rad(airy_radius_rad(pupil_m, wavelength_nm)),
                                  expected["airy_first_zero_radius_arcmin"]);
        test::expect_vector_value(airy_defocus_d(pupil_m, wavelength_nm),
                                  expected["defocus_for_blur_equal_airy_D"]);
        test::expect_vector_value(quarter_wave_defocus_d(pupil_m, wavelength_nm),
                                  expected["quarter_wave_defocus_D"]);
    }
}

// Of two unit disks whose centres are 2s apart: the area where they overlap, over pi.
double overlap(double s)
{
    constexpr int steps = 100000;
    double area = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double y = -1.0 + 2.0 * (i + 0.5) / steps;
        area += std::max(0.0, 2.0 * (std::sqrt(1.0 - y * y) - s)) * 2.0 / steps;
    }
    return area / pi;
}

TEST(Diffraction, mtf_is_the_overlap_of_the_pupil_with_itself)
{
    // 3 mm at 555 nm: 94.34 cycles/degree.
    const double cutoff_cpd = diffraction_cutoff_cpd(3e-3, 555.0);
    EXPECT_NEAR(cutoff_cpd, 94.343, 1e-3);
    for (const double s : {0.0, 0.1, 0.25, 0.5, 0.9, 0.999}) {
        EXPECT_NEAR(diffraction_mtf(s * cutoff_cpd, 3e-3, 555.0), overlap(s), 1e-6) << s;
        EXPECT_EQ(diffraction_mtf(-s * cutoff_cpd, 3e-3, 555.0),
                  diffraction_mtf(s * cutoff_cpd, 3e-3, 555.0));
    }
    EXPECT_EQ(diffraction_mtf(cutoff_cpd, 3e-3, 555.0), 0.0);
    EXPECT_EQ(diffraction_mtf(2.0 * cutoff_cpd, 3e-3, 555.0), 0.0);
}

TEST(Diffraction, dominates_until_the_blur_is_as_long_as_the_airy_disk)
{
    for (const double pupil_m : {2e-3, 4e-3}) {
        const auto dominates = [&](const Prescription& rx) {
            const auto eye = make_eye(
                {.rx = rx, .rx_plane = RxPlane::EntrancePupil, .pupil_diameter_m = pupil_m});
            return diffraction_dominates(spot_moments(make_spot(trace_pupil(*eye), 0.0)), pupil_m,
                                         555.0);
        };
        const double limit_d = airy_defocus_d(pupil_m, 555.0);
        EXPECT_TRUE(dominates({.sphere_d = -0.99 * limit_d}));
        EXPECT_FALSE(dominates({.sphere_d = -1.01 * limit_d}));
        EXPECT_TRUE(dominates({.cylinder_d = -0.99 * limit_d, .axis_deg = 30.0}));
        EXPECT_FALSE(dominates({.cylinder_d = -1.01 * limit_d, .axis_deg = 30.0}));
    }
}

}  // namespace
}  // namespace eye_render
