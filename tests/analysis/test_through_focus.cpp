// Best focus and focal lines against the matrix that the eye was made of.

#include "analysis/through_focus.h"

#include "eyes.h"

#include "analysis/spot.h"
#include "eye/eye_factory.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

void expect_same_matrix(const PowerMatrix& actual, const PowerMatrix& expected, double tolerance_d)
{
    EXPECT_NEAR(actual.xx_d, expected.xx_d, tolerance_d);
    EXPECT_NEAR(actual.xy_d, expected.xy_d, tolerance_d);
    EXPECT_NEAR(actual.yy_d, expected.yy_d, tolerance_d);
}

TEST(ThroughFocus, of_the_paraxial_eye_is_its_matrix)
{
    for (const Prescription& rx :
         {Prescription{}, Prescription{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0},
          Prescription{.sphere_d = 5.0, .cylinder_d = -3.0, .axis_deg = 30.0}}) {
        const auto eye = make_eye({.rx = rx, .accommodation_d = 1.0});
        const PowerMatrix k = eye->retinal_conjugate_d();
        for (const V2d& chief_slope : {V2d(0.0), V2d(0.3, -0.2)}) {
            const ThroughFocus focus =
                through_focus(trace_pupil(*eye, {.chief_slope = chief_slope}));
            ASSERT_TRUE(focus.best_focus_d.has_value());
            // The circle of least confusion lies at the mean; the samples are round to 1e-4.
            EXPECT_NEAR(*focus.best_focus_d, k.mean_d(), 1e-3) << rx.sphere_d;
            expect_same_matrix(focus.conjugate_d, k, 1e-9);
        }
    }
}

TEST(ThroughFocus, of_an_eye_behind_a_lens_is_where_its_error_vanishes)
{
    const auto eye = make_eye({.rx = Prescription{.sphere_d = -6.0},
                               .accommodation_d = 3.0,
                               .worn = glasses({.sphere_d = -4.0}, 12e-3)});
    const ThroughFocus focus = through_focus(trace_pupil(*eye));
    EXPECT_GT(*focus.best_focus_d, 4.0);
    EXPECT_NEAR(eye->error_d(*focus.best_focus_d).mean_d(), 0.0, 1e-9);
}

TEST(ThroughFocus, best_focus_has_the_smallest_spot)
{
    const auto eye =
        make_eye({.model = EyeModelKind::Paper,
                  .rx = Prescription{.sphere_d = -2.0, .cylinder_d = -3.0, .axis_deg = 30.0}});
    const PupilTrace trace = trace_pupil(*eye);
    const double best_d = through_focus(trace).best_focus_d.value();
    const auto rms_rad = [&](double vergence_d) {
        return spot_moments(make_spot(trace, vergence_d)).rms_radius_rad();
    };
    EXPECT_LT(rms_rad(best_d), rms_rad(best_d - 0.01));
    EXPECT_LT(rms_rad(best_d), rms_rad(best_d + 0.01));
}

TEST(ThroughFocus, a_pinhole_and_a_closed_eye_focus_nowhere)
{
    EXPECT_FALSE(through_focus(trace_pupil(*make_eye({.model = EyeModelKind::Pinhole})))
                     .best_focus_d.has_value());
    EXPECT_FALSE(through_focus(trace_pupil(test::ClosedEye())).best_focus_d.has_value());
}

}  // namespace
}  // namespace eye_render
