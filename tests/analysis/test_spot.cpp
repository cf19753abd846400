// Sampled spots of each model against closed forms.

#include "analysis/spot.h"

#include "eyes.h"

#include "analysis/blur_ellipse.h"
#include "base/units.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

// 65536 stratified samples of the disk: its moments are within 1e-4 of themselves.
constexpr double sampling_tolerance = 1e-3;

Spot spot_of(const EyeModel& eye, double object_vergence_d, const V2d& chief_slope = V2d(0.0))
{
    return make_spot(trace_pupil(eye, {.chief_slope = chief_slope}), object_vergence_d);
}

SpotMoments moments_of(const EyeSpec& spec, double object_vergence_d = 0.0)
{
    return spot_moments(spot_of(*make_eye(spec), object_vergence_d));
}

TEST(Spot, second_moments_of_the_paraxial_eye_are_those_of_its_error)
{
    for (const Prescription& rx :
         {Prescription{.sphere_d = -3.0}, Prescription{.sphere_d = 2.5},
          Prescription{.cylinder_d = -2.0, .axis_deg = 30.0},
          Prescription{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0},
          Prescription{.sphere_d = 4.0, .cylinder_d = -1.5, .axis_deg = 160.0}}) {
        for (const double object_vergence_d : {0.0, 0.5}) {
            SCOPED_TRACE(testing::Message() << rx.sphere_d << " x " << rx.axis_deg << " at "
                                            << object_vergence_d << " D");
            const EyeSpec spec{.rx = rx, .pupil_diameter_m = 5e-3};
            const SpotMoments moments = moments_of(spec, object_vergence_d);
            const PowerMatrix e = make_eye(spec)->error_d(object_vergence_d);
            // The covariance of E p over a disk of radius R is R^2/4 E E'.
            const double quarter = 0.25 * 2.5e-3 * 2.5e-3;
            const double xx = quarter * (e.xx_d * e.xx_d + e.xy_d * e.xy_d);
            const double xy = quarter * e.xy_d * (e.xx_d + e.yy_d);
            const double yy = quarter * (e.yy_d * e.yy_d + e.xy_d * e.xy_d);
            const double tolerance = sampling_tolerance * (xx + yy);
            EXPECT_NEAR(moments.xx, xx, tolerance);
            EXPECT_NEAR(moments.xy, xy, tolerance);
            EXPECT_NEAR(moments.yy, yy, tolerance);
            EXPECT_NEAR(moments.mean_rad.length(), 0.0, std::sqrt(xx + yy) * sampling_tolerance);
        }
    }
}

void expect_same_ellipse(const BlurEllipse& sampled, const BlurEllipse& expected)
{
    const double tolerance_arcmin = sampling_tolerance * expected.major_arcmin;
    EXPECT_NEAR(sampled.major_arcmin, expected.major_arcmin, tolerance_arcmin);
    EXPECT_NEAR(sampled.minor_arcmin, expected.minor_arcmin, tolerance_arcmin);
    EXPECT_NEAR(sampled.rms_radius_arcmin, expected.rms_radius_arcmin, tolerance_arcmin);
    ASSERT_EQ(sampled.angle_deg.has_value(), expected.angle_deg.has_value());
    if (expected.angle_deg) {
        EXPECT_NEAR(std::remainder(*sampled.angle_deg - *expected.angle_deg, 180.0), 0.0, 0.1);
    }
}

TEST(Spot, ellipse_of_an_eye_with_or_without_lenses_is_the_closed_form)
{
    const Prescription rx{.sphere_d = -4.0, .cylinder_d = -1.5, .axis_deg = 20.0};
    const Prescription strong{.sphere_d = 8.0, .cylinder_d = -2.0, .axis_deg = 70.0};
    for (const EyeSpec& spec :
         {EyeSpec{.rx = Prescription{.sphere_d = -3.0}}, EyeSpec{.rx = rx},
          EyeSpec{.rx = rx, .worn = glasses({.sphere_d = -10.0}, 12e-3)},
          EyeSpec{.rx = rx, .worn = glasses(strong, 14e-3)},
          EyeSpec{.rx = rx, .worn = contact_lens({.sphere_d = -6.0, .cylinder_d = -1.0})}}) {
        for (const double object_vergence_d : {0.0, 2.5}) {
            const auto eye = make_eye(spec);
            SCOPED_TRACE(testing::Message() << (spec.worn ? spec.worn->power_d.mean_d() : 0.0)
                                            << " D worn, object " << object_vergence_d << " D");
            expect_same_ellipse(
                spot_ellipse(moments_of(spec, object_vergence_d)),
                blur_ellipse(eye->error_d(object_vergence_d), eye->pupil_diameter_m()));
        }
    }
}

TEST(Spot, off_the_axis_is_foreshortened_as_the_pictures_plane_is)
{
    // A disk of slopes, seen 30 degrees from the axis: cos^2 along the radius, cos across it.
    const auto eye = make_eye({.rx = Prescription{.sphere_d = -3.0}});
    for (const double azimuth_rad : {0.0, 0.5 * pi}) {
        const V2d outward(std::cos(azimuth_rad), std::sin(azimuth_rad));
        const SpotMoments axial = spot_moments(spot_of(*eye, 0.0));
        const SpotMoments moments =
            spot_moments(spot_of(*eye, 0.0, outward * std::tan(rad_from_deg(30.0))));
        const double radial = azimuth_rad == 0.0 ? moments.xx : moments.yy;
        const double tangential = azimuth_rad == 0.0 ? moments.yy : moments.xx;
        EXPECT_NEAR(radial / axial.xx, std::pow(0.75, 2), sampling_tolerance);
        EXPECT_NEAR(tangential / axial.xx, 0.75, sampling_tolerance);
        EXPECT_NEAR(moments.xy / axial.xx, 0.0, sampling_tolerance);
    }
}

TEST(Spot, of_the_papers_eye_with_a_sphere_is_the_disk)
{
    const SpotMoments moments =
        moments_of({.model = EyeModelKind::Paper, .rx = Prescription{.sphere_d = -3.0}});
    EXPECT_NEAR(arcmin_from_rad(moments.rms_radius_rad()), 14.585,
                0.01);  // 4 mm x 3 D, over 2 sqrt 2
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
    const SpotMoments spot = moments_of(
        {.model = EyeModelKind::Paper, .rx = Prescription{.cylinder_d = -6.0, .axis_deg = 90.0}});
    EXPECT_NEAR(spot.xx, scale * xx, sampling_tolerance * scale * xx);
    EXPECT_NEAR(spot.yy, scale * yy, sampling_tolerance * scale * xx);
    EXPECT_NEAR(spot.xy, 0.0, sampling_tolerance * scale * xx);
    EXPECT_GT(spot.yy, 0.2 * spot.xx) << "no focal line";
}

TEST(Spot, of_a_pinhole_is_a_point)
{
    const Spot spot = spot_of(*make_eye({.model = EyeModelKind::Pinhole}), 3.0);
    const SpotMoments moments = spot_moments(spot);
    EXPECT_EQ(moments.xx + moments.yy + moments.mean_rad.length(), 0.0);
    EXPECT_EQ(spot.transmitted, 1.0);
}

TEST(Spot, counts_only_what_the_eye_transmits)
{
    const PupilTrace trace = trace_pupil(test::HalfEye(), {.samples = 4096});
    EXPECT_EQ(trace.counts.transmitted, 2048u);
    EXPECT_EQ(trace.counts.vignetted, 2048u);
    EXPECT_EQ(trace.counts.missed + trace.counts.total_reflection, 0u);
    const Spot spot = make_spot(trace, 1.0);
    EXPECT_EQ(spot.points.size(), 2048u);
    EXPECT_NEAR(spot.transmitted, 0.25, 1e-12);
    // The centroid of a half disk of radius R lies 4R / 3 pi from its edge. What enters below is
    // gathered from below where the eye focuses beyond the point, so the point appears above.
    const SpotMoments moments = spot_moments(spot);
    EXPECT_NEAR(moments.mean_rad.y, 4.0 / (3.0 * pi) * 1e-3, 1e-6);
    EXPECT_NEAR(moments.mean_rad.x, 0.0, 1e-6);
}

TEST(Spot, of_a_closed_eye_is_empty)
{
    const Spot spot = spot_of(test::ClosedEye(), 0.0);
    EXPECT_TRUE(spot.points.empty());
    EXPECT_EQ(spot.transmitted, 0.0);
    EXPECT_EQ(spot_ellipse(spot_moments(spot)).major_arcmin, 0.0);
    EXPECT_EQ(spot_moments(Spot{.points = {SpotPoint{.weight = 0.0}}}).rms_radius_rad(), 0.0);
}

}  // namespace
}  // namespace eye_render
