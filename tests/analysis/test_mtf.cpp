// Geometrical modulation transfer against its closed form: the transform of an evenly filled
// ellipse is 2 J1(x)/x (Hopkins 1955, "The frequency response of a defocused optical system",
// geometrical approximation).

#include "analysis/mtf.h"

#include "eyes.h"

#include "analysis/diffraction.h"
#include "base/units.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

#include <array>

namespace eye_render {
namespace {

constexpr std::array frequencies_cpd{0.0, 1.0, 3.0, 5.0, 10.0, 20.0, 30.0};

// Of a blur with half width h across the bars.
double jinc(double half_width_rad, double frequency_cpd)
{
    const double x = 2.0 * pi * frequency_cpd * deg_from_rad(half_width_rad);
    return x == 0.0 ? 1.0 : std::abs(2.0 * std::cyl_bessel_j(1.0, x) / x);
}

TEST(Mtf, of_any_ellipse_along_any_meridian_is_the_jinc)
{
    for (const Prescription& rx :
         {Prescription{.sphere_d = -0.5}, Prescription{.sphere_d = 1.0},
          Prescription{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0}}) {
        for (const double object_vergence_d : {0.0, 2.0}) {
            const auto eye = make_eye({.rx = rx, .pupil_diameter_m = 4e-3});
            const Spot spot = make_spot(trace_pupil(*eye), object_vergence_d);
            for (const double meridian_deg : {0.0, 20.0, 90.0, 110.0, 160.0}) {
                const double meridian_rad = rad_from_deg(meridian_deg);
                const V2d across(std::cos(meridian_rad), std::sin(meridian_rad));
                const double half_width_rad =
                    2e-3 * (eye->error_d(object_vergence_d) * across).length();
                const auto mtf = geometric_mtf(spot, meridian_deg, frequencies_cpd);
                for (std::size_t i = 0; i < frequencies_cpd.size(); ++i) {
                    EXPECT_NEAR(mtf[i], jinc(half_width_rad, frequencies_cpd[i]), 1e-3)
                        << rx.sphere_d << " at " << object_vergence_d << " D, "
                        << frequencies_cpd[i] << " cycles/degree at " << meridian_deg;
                }
            }
        }
    }
}

TEST(Mtf, is_1_for_an_eye_in_focus_and_at_frequency_0)
{
    const Spot sharp = make_spot(trace_pupil(*make_eye({})), 0.0);
    for (const double value : geometric_mtf(sharp, 30.0, frequencies_cpd)) {
        EXPECT_NEAR(value, 1.0, 1e-12);
    }
}

TEST(Mtf, with_diffraction_is_the_diffraction_limit_for_an_eye_in_focus)
{
    for (const double pupil_m : {2e-3, 5e-3}) {
        const auto eye = make_eye({.pupil_diameter_m = pupil_m});
        const auto mtf =
            wave_mtf(make_spot(trace_pupil(*eye), 0.0),
                     {.diameter_m = pupil_m, .wavelength_nm = 600.0}, 70.0, frequencies_cpd);
        for (std::size_t i = 0; i < frequencies_cpd.size(); ++i) {
            EXPECT_NEAR(mtf[i], diffraction_mtf(frequencies_cpd[i], pupil_m, 600.0), 1e-3);
        }
    }
}

// The overlap of two copies of the pupil, s = f / cutoff, cut into strips across which the
// defocused wavefronts' difference is constant (Hopkins 1955, eq. 15).
double defocused_transfer(double defocus_d, double frequency_cpd, double pupil_m, double nm)
{
    constexpr int steps = 20000;
    const double radius_m = 0.5 * pupil_m;
    const double s = frequency_cpd / diffraction_cutoff_cpd(pupil_m, nm);
    const double phase_per_m = 2.0 * pi * deg_from_rad(frequency_cpd) * defocus_d;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double x = (1.0 - s) * (-1.0 + 2.0 * (i + 0.5) / steps);
        const double height = std::sqrt(1.0 - std::pow(std::abs(x) + s, 2));
        sum += 2.0 * height * std::cos(phase_per_m * radius_m * x) * 2.0 * (1.0 - s) / steps;
    }
    return std::abs(sum) / pi;
}

TEST(Mtf, with_diffraction_is_hopkins_transfer_of_defocus)
{
    for (const double defocus_d : {0.0, 0.1, 0.25, 0.5, 1.0}) {
        for (const double pupil_m : {2e-3, 4e-3}) {
            const auto eye = make_eye({.rx = Prescription{.sphere_d = -defocus_d},
                                       .rx_plane = RxPlane::EntrancePupil,
                                       .pupil_diameter_m = pupil_m});
            const auto mtf =
                wave_mtf(make_spot(trace_pupil(*eye), 0.0),
                         {.diameter_m = pupil_m, .wavelength_nm = 555.0}, 40.0, frequencies_cpd);
            for (std::size_t i = 0; i < frequencies_cpd.size(); ++i) {
                EXPECT_NEAR(mtf[i],
                            defocused_transfer(defocus_d, frequencies_cpd[i], pupil_m, 555.0),
                            1e-3)
                    << defocus_d << " D, " << pupil_m << " m, " << frequencies_cpd[i]
                    << " cycles/degree";
            }
        }
    }
}

TEST(Mtf, is_0_when_nothing_is_seen)
{
    const Spot nothing = make_spot(trace_pupil(test::ClosedEye()), 0.0);
    for (const double value : geometric_mtf(nothing, 0.0, frequencies_cpd)) {
        EXPECT_EQ(value, 0.0);
    }
}

}  // namespace
}  // namespace eye_render
