// The paper's eye where its equations 6 and 8, taken literally, have a pole.

#include "trial.h"

#include "eye/models.h"

#include <cmath>

namespace eye_render::test {
namespace {

// D < 0, a virtual object, is no accommodation that an eye can have, so the factory is passed by.
TEST(PaperLimits, crosses_from_a_near_object_through_infinity_to_a_virtual_one)
{
    const V2d p_m(2e-3, -1e-3);
    const PowerMatrix rx =
        power_matrix_camera({.sphere_d = 2.0, .cylinder_d = -3.0, .axis_deg = 20.0});
    const auto slope = [&](double accommodation_d) {
        return make_paper_eye(rx, accommodation_d, 4e-3, 17e-3)->ray({0.3, 0.1}, p_m, 555.0).slope;
    };
    for (const double size_d : {1e-3, 1e-9, 1e-300, 5e-324, 0.0}) {
        EXPECT_NEAR((slope(size_d) - slope(-size_d)).length(), 2.0 * size_d * p_m.length(), 1e-15)
            << size_d << " D";
    }
    EXPECT_NEAR((slope(-15.0) - slope(15.0)).length(), 30.0 * p_m.length(), 1e-14);
}

// Equation 8 has its pole at 1/d_eye. Up to nine tenths of it the eye exists, and its focus keeps
// following the prescription; beyond it is refused.
TEST(PaperLimits, follows_the_prescription_until_the_lens_would_have_no_power)
{
    for (const double eye_length_mm : {31.0, 33.0, 36.0, 40.0}) {
        const double last_d = 0.9 / (eye_length_mm * 1e-3);
        Trial trial{.model = EyeModelKind::Paper,
                    .eye_length_mm = eye_length_mm,
                    .pupil_share = 1.0,
                    .pupil_angle_deg = 30.0};
        for (const double short_of_it_d : {1.0, 1e-3, 1e-9, 1e-12}) {
            trial.sphere_d = last_d - short_of_it_d;
            const auto eye = made(trial);
            ASSERT_TRUE(eye) << trial;
            const V2d slope = ray_of(*eye, trial).slope;
            EXPECT_NEAR((slope - pupil_point_m(trial) * trial.sphere_d).length(), 0.0, 1e-14)
                << trial;
            trial.sphere_d = last_d + short_of_it_d;
            EXPECT_FALSE(made(trial)) << trial;
        }
    }
}

}  // namespace
}  // namespace eye_render::test
