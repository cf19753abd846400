// What the factory refuses, and to which plane it refers a prescription.

#include "eye/eye_factory.h"
#include "eye/pupil_size.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace eye_render {
namespace {

std::string refusal(const EyeSpec& spec)
{
    try {
        static_cast<void>(make_eye(spec));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

TEST(EyeFactory, refuses_what_is_out_of_range_in_every_model)
{
    for (const EyeModelKind model : eye_model_kinds) {
        SCOPED_TRACE(to_string(model));
        EXPECT_EQ(refusal({.model = model, .pupil_diameter_m = 10e-3}),
                  "pupil_mm is 10 mm; expected 0 to 9 mm");
        EXPECT_EQ(refusal({.model = model, .pupil_diameter_m = -1e-3}),
                  "pupil_mm is -1 mm; expected 0 to 9 mm");
        EXPECT_EQ(refusal({.model = model, .accommodation_d = 21.0}),
                  "accommodation_d is 21 D; expected 0 to 20 D");
        EXPECT_EQ(refusal({.model = model, .rx = Prescription{.sphere_d = NAN}}),
                  "sphere_d is nan D; expected -30 to 30 D");
        EXPECT_EQ(refusal({.model = model, .rx = PowerMatrix{8.0, 0.0, -8.0}}),
                  "cylinder of rx is 16 D; expected 0 to 15 D");
        EXPECT_EQ(refusal({.model = model, .rx = PowerMatrix::sphere(38.0)}),
                  "mean sphere of rx is 38 D; expected -37.5 to 37.5 D");
        EXPECT_EQ(refusal({.model = model, .vertex_m = 21e-3}),
                  "vertex_mm is 21 mm; expected 0 to 20 mm");
    }
}

TEST(EyeFactory, accepts_both_ends_of_every_range)
{
    const Wavefront wavefront{.pupil_diameter_m = max_pupil_diameter_m};
    for (const EyeModelKind model : eye_model_kinds) {
        // These eyes' surfaces allow no more, and they say so.
        const bool limited = model == EyeModelKind::Arizona || model == EyeModelKind::LeGrand;
        const double most_d = limited ? 7.5 : max_accommodation_d;
        for (const double end : {0.0, 1.0}) {
            EXPECT_EQ(refusal({.model = model,
                               .vertex_m = end * max_vertex_m,
                               .pupil_diameter_m = end * max_pupil_diameter_m,
                               .accommodation_d = end * most_d,
                               .exact_trace = true,
                               .wavefront = wavefront}),
                      "accepted");
        }
        EXPECT_EQ(refusal({.model = model,
                           .rx = Prescription{.sphere_d = -30.0, .cylinder_d = -15.0},
                           .exact_trace = true,
                           .wavefront = wavefront}),
                  "accepted");
        EXPECT_EQ(refusal({.model = model,
                           .rx = Prescription{.sphere_d = 30.0, .cylinder_d = 15.0},
                           .exact_trace = true,
                           .wavefront = wavefront}),
                  "accepted");
    }
}

TEST(EyeFactory, accepts_the_widest_and_narrowest_pupil_that_a_formula_gives)
{
    // The clamp at 9 mm is made in millimetres and checked in metres.
    const PupilSize dark = pupil_size(PupilFormula::Paper, {.luminance_cd_m2 = 1e-6});
    const PupilSize bright = pupil_size(PupilFormula::Holladay, {.luminance_cd_m2 = 1e6});
    ASSERT_EQ(dark.clamps.size() + bright.clamps.size(), 2u);
    EXPECT_EQ(refusal({.pupil_diameter_m = dark.diameter_m}), "accepted");
    EXPECT_EQ(refusal({.pupil_diameter_m = bright.diameter_m}), "accepted");
}

TEST(EyeFactory, refers_minus_10_to_the_cornea_and_the_entrance_pupil)
{
    // -10 at 12 mm is -8.93 at the cornea and -8.69 at the entrance pupil, by 1/F' = 1/F - d.
    const Prescription rx{.sphere_d = -10.0};
    EXPECT_NEAR(
        rx_at_entrance_pupil({.rx = rx, .rx_plane = RxPlane::Spectacle, .vertex_m = 12e-3}).xx_d,
        1.0 / (-0.1 - 15.05e-3), 1e-12);
    EXPECT_NEAR(rx_at_entrance_pupil({.rx = Prescription{.sphere_d = 1.0 / (-0.1 - 12e-3)},
                                      .rx_plane = RxPlane::Cornea})
                    .xx_d,
                1.0 / (-0.1 - 15.05e-3), 1e-12);
    EXPECT_EQ(rx_at_entrance_pupil({.rx = rx, .rx_plane = RxPlane::EntrancePupil}).xx_d, -10.0);
}

TEST(EyeFactory, takes_a_matrix_in_the_camera_frame)
{
    const Prescription rx{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0};
    const PowerMatrix from_text = rx_at_entrance_pupil({.rx = rx});
    const PowerMatrix from_matrix = rx_at_entrance_pupil({.rx = power_matrix_camera(rx)});
    EXPECT_EQ(from_text.xy_d, from_matrix.xy_d);
    EXPECT_GT(from_text.xy_d, 0.0);  // axis 160 is seen at 20 degrees
}

}  // namespace
}  // namespace eye_render
