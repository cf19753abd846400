// Sampled spots of each model against closed forms.

#include "analysis/spot.h"

#include "analysis/blur_ellipse.h"
#include "base/units.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

// 65536 stratified samples of the disk: its moments are within 1e-4 of themselves.
constexpr double sampling_tolerance = 1e-3;

TEST(Spot, second_moments_of_the_paraxial_eye_are_those_of_its_ellipse)
{
    for (const Prescription& rx :
         {Prescription{.sphere_d = -3.0}, Prescription{.sphere_d = 2.5},
          Prescription{.cylinder_d = -2.0, .axis_deg = 30.0},
          Prescription{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0},
          Prescription{.sphere_d = 4.0, .cylinder_d = -1.5, .axis_deg = 160.0}}) {
        for (const double object_vergence_d : {0.0, 0.5}) {
            const auto eye = make_eye({.rx = rx, .pupil_diameter_m = 5e-3});
            const SpotMoments spot = spot_moments(
                *eye, {.chief_slope = {0.2, -0.1}, .object_vergence_d = object_vergence_d});
            const PowerMatrix e =
                eye->retinal_conjugate_d() - PowerMatrix::sphere(object_vergence_d);
            // The covariance of E p over a disk of radius R is R^2/4 E E'.
            const double quarter = 0.25 * 2.5e-3 * 2.5e-3;
            const double xx = quarter * (e.xx_d * e.xx_d + e.xy_d * e.xy_d);
            const double xy = quarter * e.xy_d * (e.xx_d + e.yy_d);
            const double yy = quarter * (e.yy_d * e.yy_d + e.xy_d * e.xy_d);
            const double tolerance = sampling_tolerance * (xx + yy);
            EXPECT_NEAR(spot.xx, xx, tolerance) << rx.sphere_d << " " << rx.axis_deg;
            EXPECT_NEAR(spot.xy, xy, tolerance) << rx.sphere_d << " " << rx.axis_deg;
            EXPECT_NEAR(spot.yy, yy, tolerance) << rx.sphere_d << " " << rx.axis_deg;
            EXPECT_NEAR(spot.mean.length(), 0.0, std::sqrt(xx + yy) * sampling_tolerance);
            EXPECT_EQ(spot.transmitted, 1.0);

            const BlurEllipse blur = blur_ellipse(e, eye->pupil_diameter_m());
            EXPECT_NEAR(arcmin_from_rad(std::sqrt(spot.xx + spot.yy)), blur.rms_radius_arcmin,
                        sampling_tolerance * blur.rms_radius_arcmin);
            if (blur.angle_deg) {
                EXPECT_NEAR(std::remainder(
                                deg_from_rad(0.5 * std::atan2(2.0 * spot.xy, spot.xx - spot.yy)) -
                                    *blur.angle_deg,
                                180.0),
                            0.0, 0.1);
            }
        }
    }
}

TEST(Spot, of_the_papers_eye_with_a_sphere_is_the_disk)
{
    const auto eye =
        make_eye({.model = EyeModelKind::Paper, .rx = Prescription{.sphere_d = -3.0}});
    const SpotMoments spot = spot_moments(*eye);
    const double rms_radius_arcmin = arcmin_from_rad(std::sqrt(spot.xx + spot.yy));
    EXPECT_NEAR(rms_radius_arcmin, 14.585, 0.01);  // 4 mm x 3 D, over 2 sqrt 2
}

TEST(Spot, of_the_papers_cylinder_is_a_bow_tie_and_no_line)
{
    // -6 x 90 through 4 mm: 20.63 arcmin RMS across the axis and none along it in an exact eye.
    // The paper's spreads by r P(phi) along each spoke, phi counted from the vertical axis, so its
    // second moments are R^2/2 times the means of (P sin)^2 and (P cos)^2.
    constexpr int steps = 10000;
    constexpr double f_axis_m = 0.017;
    constexpr double f_across_m = 0.017 / (1.0 + 0.017 * 6.0);
    double xx = 0.0;
    double yy = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double quarter_turns = (i + 0.5) / steps;
        const double phi_rad = 0.5 * pi * quarter_turns;
        const double power_d =
            1.0 / 0.017 - 1.0 / (f_axis_m + (f_across_m - f_axis_m) * quarter_turns);
        xx += std::pow(power_d * std::sin(phi_rad), 2) / steps;
        yy += std::pow(power_d * std::cos(phi_rad), 2) / steps;
    }
    const double scale = 0.5 * 2e-3 * 2e-3;
    const auto eye = make_eye(
        {.model = EyeModelKind::Paper, .rx = Prescription{.cylinder_d = -6.0, .axis_deg = 90.0}});
    const SpotMoments spot = spot_moments(*eye);
    EXPECT_NEAR(spot.xx, scale * xx, sampling_tolerance * scale * xx);
    EXPECT_NEAR(spot.yy, scale * yy, sampling_tolerance * scale * xx);
    EXPECT_NEAR(spot.xy, 0.0, sampling_tolerance * scale * xx);
    EXPECT_GT(spot.yy, 0.2 * spot.xx) << "no focal line";
}

TEST(Spot, of_a_pinhole_is_a_point)
{
    const auto eye = make_eye({.model = EyeModelKind::Pinhole});
    const SpotMoments spot = spot_moments(*eye, {.object_vergence_d = 3.0});
    EXPECT_EQ(spot.xx + spot.yy + spot.mean.length(), 0.0);
    EXPECT_EQ(spot.transmitted, 1.0);
}

// An eye whose upper half is covered, and which lets only half of the light through.
class HalfEye final : public EyeModel {
public:
    [[nodiscard]] EyeRay ray(const V2d& slope, const V2d& pupil_point_m, double) const override
    {
        if (pupil_point_m.y > 0.0) {
            return {.fate = RayFate::Vignetted};
        }
        return {.origin_eye_m = {pupil_point_m.x, pupil_point_m.y, 0.0},
                .slope = slope,
                .weight = 0.5};
    }
    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return {}; }
    [[nodiscard]] double pupil_diameter_m() const override { return 2e-3; }
};

TEST(Spot, counts_only_what_the_eye_transmits)
{
    const SpotMoments spot = spot_moments(HalfEye(), {.object_vergence_d = 1.0});
    EXPECT_NEAR(spot.transmitted, 0.25, 1e-3);
    // The centroid of a half disk of radius R lies 4R / 3 pi from its edge.
    EXPECT_NEAR(spot.mean.y, -4.0 / (3.0 * pi) * 1e-3, 1e-6);
    EXPECT_NEAR(spot.mean.x, 0.0, 1e-6);
}

}  // namespace
}  // namespace eye_render
