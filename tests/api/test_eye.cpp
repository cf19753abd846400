// What a person says they wear, and the error that is left behind it.

#include "api/eye.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

double largest_error_d(const EyeDescription& description, double object_vergence_d = 0.0)
{
    const PowerMatrix error_d = make_eye(description)->error_d(object_vergence_d);
    return std::abs(error_d.mean_d()) + error_d.astigmatism_d();
}

constexpr double rounding_d = 1e-12;

TEST(Eye, full_correction_leaves_no_error_wherever_the_eye_was_refracted)
{
    for (const Prescription& rx :
         {Prescription{.sphere_d = -8.0, .cylinder_d = -2.0, .axis_deg = 30.0},
          Prescription{.sphere_d = 9.0, .cylinder_d = -3.0, .axis_deg = 160.0}}) {
        for (const RxPlane plane : rx_planes) {
            for (const Correction correction : {Correction::Glasses, Correction::Contacts}) {
                for (const EyeModelKind model : {EyeModelKind::Paraxial, EyeModelKind::Paper}) {
                    EyeDescription eye{.model = model,
                                       .rx = rx,
                                       .rx_plane = plane,
                                       .vertex_mm = 14.0,
                                       .correction = correction};
                    EXPECT_LT(largest_error_d(eye), rounding_d)
                        << to_string(plane) << ", " << to_string(correction) << ", "
                        << to_string(model);
                }
            }
        }
    }
}

TEST(Eye, glasses_that_are_too_weak_leave_the_rest)
{
    const EyeDescription eye{.rx = {.sphere_d = -4.0},
                             .correction = Correction::Glasses,
                             .worn = Prescription{.sphere_d = -3.5}};
    // Both powers at the pupil, 15.05 mm behind the glasses.
    const auto at_pupil_d = [](double d) { return d / (1.0 - 0.01505 * d); };
    EXPECT_NEAR(make_eye(eye)->error_d(0.0).mean_d(), at_pupil_d(-3.5) - at_pupil_d(-4.0),
                rounding_d);
}

TEST(Eye, far_point_behind_glasses_is_where_a_point_is_sharp)
{
    EXPECT_EQ(far_point_m(*make_eye(EyeDescription{})), std::numeric_limits<double>::infinity());
    const EyeDescription eye{.rx = {.sphere_d = -10.0},
                             .correction = Correction::Glasses,
                             .worn = Prescription{.sphere_d = -6.0}};
    // 4 D are left at the glasses, 15.05 mm before the pupil.
    EXPECT_NEAR(far_point_m(*make_eye(eye)), 0.25 + 0.01505, 1e-9);
}

TEST(Eye, reading_part_is_sharp_one_addition_before_the_glasses)
{
    EyeDescription eye{.rx = {.sphere_d = -1.0, .add_d = 2.5},
                       .correction = Correction::Glasses,
                       .near_part = true};
    const double object_m = 1.0 / 2.5 + 12e-3 + 3.05e-3;
    EXPECT_LT(largest_error_d(eye, 1.0 / object_m), rounding_d);
    eye.near_part = false;
    EXPECT_LT(largest_error_d(eye), rounding_d) << "the distance part is for far away";
}

TEST(Eye, contact_lenses_have_neither_prism_nor_a_reading_part)
{
    EyeDescription eye{.rx = {.sphere_d = -3.0, .base_up_pd = 4.0},
                       .correction = Correction::Contacts};
    EXPECT_EQ(make_eye(eye)->ray(V2d(0.0), V2d(0.0), 555.0).slope, V2d(0.0));
    eye.near_part = true;
    EXPECT_THROW((void)make_eye(eye), std::invalid_argument);
}

TEST(Eye, nothing_can_be_worn_without_a_correction)
{
    EXPECT_THROW((void)make_eye(EyeDescription{.worn = Prescription{}}), std::invalid_argument);
    EXPECT_THROW((void)make_eye(EyeDescription{.near_part = true}), std::invalid_argument);
}

TEST(Eye, contact_lenses_are_what_they_are_made_to)
{
    const EyeDescription eye{.rx = {.sphere_d = -6.0},
                             .correction = Correction::Contacts,
                             .worn = Prescription{.sphere_d = -6.0 / (1.0 + 0.012 * 6.0)}};
    EXPECT_LT(largest_error_d(eye), rounding_d);
}

}  // namespace
}  // namespace eye_render
