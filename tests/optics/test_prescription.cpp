// Prescription algebra against the vectors, its own identities and its extremes.

#include "optics/prescription.h"

#include "../optics_vectors.h"

#include <limits>

namespace eye_render {
namespace {

using test::Json;

Prescription rx_of(const Json& input)
{
    return {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]};
}

void expect_rx(const Prescription& rx, const Json& expected)
{
    test::expect_vector_value(rx.sphere_d, expected["S"]);
    test::expect_vector_value(rx.cylinder_d, expected["C"]);
    test::expect_same_axis(rx.axis_deg, expected["axis"]);
}

void expect_matrix(const PowerMatrix& power, const Json& expected)
{
    test::expect_vector_value(power.xx_d, expected[0][0]);
    test::expect_vector_value(power.xy_d, expected[0][1]);
    test::expect_vector_value(power.xy_d, expected[1][0]);
    test::expect_vector_value(power.yy_d, expected[1][1]);
}

void expect_matrix(const PowerMatrix& power, const PowerMatrix& expected)
{
    expect_matrix(power, Json{{expected.xx_d, expected.xy_d}, {expected.xy_d, expected.yy_d}});
}

// Prescriptions over the whole range, minus and plus cylinders, all quadrants of axis.
std::vector<Prescription> many_prescriptions()
{
    std::vector<Prescription> result;
    for (const double sphere_d : {-30.0, -2.0, 0.0, 1.25, 30.0}) {
        for (const double cylinder_d : {-15.0, -0.75, 0.25, 15.0}) {
            for (const double axis_deg : {1.0, 30.0, 90.0, 135.0, 160.0, 180.0}) {
                result.push_back(
                    {.sphere_d = sphere_d, .cylinder_d = cylinder_d, .axis_deg = axis_deg});
            }
        }
    }
    return result;
}

TEST(Prescription, transposes_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("transpose")) {
        EYE_TRACE_VECTOR(vector);
        expect_rx(transposed(rx_of(vector["input"])), vector["expect"]);
    }
}

TEST(Prescription, transposition_keeps_the_lens)
{
    for (const Prescription& rx : many_prescriptions()) {
        expect_matrix(power_matrix_tabo(transposed(rx)), power_matrix_tabo(rx));
    }
}

TEST(Prescription, has_the_vectors_power_vector_and_matrices)
{
    for (const Json& vector : test::vectors_of_kind("power_matrix")) {
        EYE_TRACE_VECTOR(vector);
        const Prescription rx = rx_of(vector["input"]);
        const Json& expected = vector["expect"];
        test::expect_vector_value(power_vector(rx).m_d, expected["M"]);
        test::expect_vector_value(power_vector(rx).j0_d, expected["J0"]);
        test::expect_vector_value(power_vector(rx).j45_d, expected["J45"]);
        expect_matrix(power_matrix_tabo(rx), expected["F"]);
        expect_matrix(power_matrix_camera(rx), expected["F_camera"]);
    }
}

TEST(Prescription, comes_back_from_its_power_in_both_forms)
{
    for (const Prescription& rx : many_prescriptions()) {
        const CylinderForm written =
            rx.cylinder_d < 0.0 ? CylinderForm::Minus : CylinderForm::Plus;
        const CylinderForm other = rx.cylinder_d < 0.0 ? CylinderForm::Plus : CylinderForm::Minus;
        const auto expect_same = [](const Prescription& a, const Prescription& b) {
            EXPECT_NEAR(a.sphere_d, b.sphere_d, 1e-12);
            EXPECT_NEAR(a.cylinder_d, b.cylinder_d, 1e-12);
            test::expect_same_axis(a.axis_deg, b.axis_deg);
        };
        expect_same(prescription_from(power_vector(rx), written), rx);
        expect_same(prescription_from(power_matrix_tabo(rx), written), rx);
        expect_same(prescription_from(power_matrix_tabo(rx), other), transposed(rx));
    }
}

TEST(Prescription, bends_rays_as_the_vectors_in_and_out_of_a_meridian)
{
    for (const Json& vector : test::vectors_of_kind("meridional_power")) {
        EYE_TRACE_VECTOR(vector);
        const MeridionalPower power = meridional_power(power_matrix_tabo(rx_of(vector["input"])),
                                                       vector["input"]["meridian"]);
        test::expect_vector_value(power.curvital_d, vector["expect"]["curvital"]);
        test::expect_vector_value(power.torsional_d, vector["expect"]["torsional"]);
    }
}

TEST(Prescription, crossed_cylinders_add_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("add_crossed_cylinders_minus_form")) {
        EYE_TRACE_VECTOR(vector);
        Prescription sum;
        for (const Json& rx : vector["input"]["rx"]) {
            sum = crossed(sum, {.sphere_d = rx[0], .cylinder_d = rx[1], .axis_deg = rx[2]});
        }
        expect_rx(sum, vector["expect"]);
    }
}

TEST(Prescription, a_lens_and_its_opposite_leave_nothing)
{
    const Prescription rx{.sphere_d = -2.0, .cylinder_d = -0.75, .axis_deg = 160.0};
    const Prescription opposite{.sphere_d = 2.0, .cylinder_d = 0.75, .axis_deg = 160.0};
    EXPECT_EQ(crossed(rx, opposite), Prescription{});
    EXPECT_EQ(crossed({.sphere_d = -1.0, .add_d = 1.5}, {.sphere_d = 1.0, .add_d = 0.5}),
              Prescription{.add_d = 2.0});
}

TEST(Prescription, a_sphere_has_no_axis_whatever_rounding_left_of_a_cylinder)
{
    EXPECT_EQ(prescription_from(PowerVector{-1.0, 1e-13, -1e-13}), Prescription{.sphere_d = -1.0});
}

TEST(Prescription, changes_plane_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("vertex_effectivity")) {
        EYE_TRACE_VECTOR(vector);
        const Prescription rx = rx_of(vector["input"]);
        const double distance_m = vector["input"]["move_toward_eye_mm"].get<double>() * 1e-3;
        const PowerMatrix moved = moved_toward_eye(power_matrix_tabo(rx), distance_m);
        expect_matrix(moved, vector["expect"]["F"]);
        expect_rx(prescription_from(moved, rx.cylinder_d > 0.0 ? CylinderForm::Plus
                                                               : CylinderForm::Minus),
                  vector["expect"]);
    }
}

TEST(Prescription, plane_changes_are_finite_at_the_strongest_lenses_and_undo_themselves)
{
    // 14 mm vertex distance and 3.05 mm to the entrance pupil: the farthest in common use.
    constexpr double distance_m = 17.05e-3;
    for (const Prescription& rx : many_prescriptions()) {
        const PowerMatrix moved = moved_toward_eye(power_matrix_tabo(rx), distance_m);
        EXPECT_TRUE(std::isfinite(moved.xx_d + moved.xy_d + moved.yy_d));
        expect_matrix(moved_toward_eye(moved, -distance_m), power_matrix_tabo(rx));
    }
}

TEST(Prescription, refuses_a_plane_at_the_lens_focus)
{
    EXPECT_THROW(static_cast<void>(moved_toward_eye(PowerMatrix::sphere(45.0), 1.0 / 45.0)),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(moved_toward_eye(PowerMatrix::sphere(45.0), 0.1)),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(moved_toward_eye(PowerMatrix::sphere(NAN), 0.01)),
                 std::invalid_argument);
}

TEST(Prescription, axis_is_mirrored_into_the_patients_view)
{
    for (const Json& vector : test::vectors_of_kind("tabo_axis_to_camera_angle")) {
        EYE_TRACE_VECTOR(vector);
        test::expect_same_axis(camera_angle_deg(vector["input"]["axis"]),
                               vector["expect"]["angle_deg"]);
    }
    EXPECT_GE(camera_angle_deg(180.0), 0.0);
    EXPECT_LT(camera_angle_deg(0.0), 180.0);
}

// The clinical rule of thirty, a fact that owes nothing to this code's conventions: the clearest
// spoke of a clock dial, by its hour as the patient sees it, times 30 is the minus cylinder's
// axis.
TEST(Prescription, obeys_the_rule_of_thirty)
{
    for (const Json& vector : test::vectors_of_kind("clock_dial_rule_of_30")) {
        EYE_TRACE_VECTOR(vector);
        const PowerMatrix power_camera = power_matrix_camera(rx_of(vector["input"]));
        int clearest_hour = 0;
        double least_blur_d = std::numeric_limits<double>::infinity();
        for (int hour = 1; hour <= 6; ++hour) {
            // Three o'clock is +X. A far line blurs by the error across itself.
            const double across_rad = (90.0 - 30.0 * hour + 90.0) * std::acos(-1.0) / 180.0;
            const double blur_d =
                (power_camera * V2d(std::cos(across_rad), std::sin(across_rad))).length();
            if (blur_d < least_blur_d) {
                least_blur_d = blur_d;
                clearest_hour = hour;
            }
        }
        EXPECT_EQ(clearest_hour, vector["expect"]["clearest_hour"].get<int>());
    }
}

TEST(Prescription, refuses_what_is_out_of_range)
{
    const auto refusal = [](const Prescription& rx) -> std::string {
        try {
            require_valid(rx);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(refusal({.sphere_d = -30.0, .cylinder_d = 15.0, .axis_deg = 0.0}), "");
    EXPECT_EQ(refusal({.axis_deg = 190.0}), "axis_deg is 190; expected 0 to 180");
    EXPECT_EQ(refusal({.sphere_d = 31.0}), "sphere_d is 31 D; expected -30 to 30 D");
    EXPECT_EQ(refusal({.cylinder_d = -16.0}), "cylinder_d is -16 D; expected -15 to 15 D");
    EXPECT_EQ(refusal({.add_d = -1.0}), "add_d is -1 D; expected 0 to 4 D");
    EXPECT_NE(refusal({.sphere_d = NAN}), "");
}

}  // namespace
}  // namespace eye_render
