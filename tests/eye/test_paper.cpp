// The paper's eye against the vectors of its own equations.

#include "eye/eye_factory.h"
#include "eye/models.h"

#include "../optics_vectors.h"

#include "base/units.h"

namespace eye_render {
namespace {

using test::Json;

V2d pair_of(const Json& pair) { return {pair[0], pair[1]}; }

void expect_slope(const V2d& slope, const Json& expected)
{
    test::expect_vector_value(slope.x, expected[0]);
    test::expect_vector_value(slope.y, expected[1]);
}

TEST(PaperEye, relaxed_follows_equation_8_and_no_object_distance)
{
    for (const Json& vector : test::vectors_of_kind("seed_paper_eq6")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const auto eye = make_eye({.model = EyeModelKind::Paper,
                                   .rx = Prescription{.sphere_d = input["ds"]},
                                   .eye_length_m = input["d_eye_m"]});
        const V2d chief_slope = pair_of(input["chief_slope"]);
        const V2d pupil_point_m = pair_of(input["pupil_m"]);
        const V2d slope = eye->ray(chief_slope, pupil_point_m, 555.0).slope;
        expect_slope(slope, vector["expect"]["slope"]);
        // What focal length bends so: slope = u - (1/f - 1/d_eye) p.
        const double bent_d =
            (chief_slope - slope).dot(pupil_point_m) / pupil_point_m.dot(pupil_point_m);
        const double focal_length_m = 1.0 / (bent_d + 1.0 / input["d_eye_m"].get<double>());
        test::expect_vector_value(focal_length_m, vector["expect"]["f_m"]);
    }
}

TEST(PaperEye, equals_equation_6_taken_literally)
{
    for (const Json& vector : test::vectors_of_kind("seed_paper_eq6_literal")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const double eye_length_m = input["L_m"];
        // The prescription whose focal length by equation 8 is d. A virtual object (D < 0) is no
        // accommodation an eye can have, so the factory, which would refuse it, is passed by.
        const double rx_d = 1.0 / eye_length_m - 1.0 / input["d_m"].get<double>();
        const auto eye = make_paper_eye(PowerMatrix::sphere(rx_d),
                                        1.0 / input["D_m"].get<double>(), 4e-3, eye_length_m);
        expect_slope(
            eye->ray(pair_of(input["chief_slope"]), pair_of(input["pupil_m"]), 555.0).slope,
            vector["expect"]["slope"]);
        test::expect_vector_value(eye->retinal_conjugate_d().xx_d, vector["expect"]["K_D"]);
    }
}

TEST(PaperEye, interpolates_astigmatism_over_the_angle_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("seed_paper_angle_interpolated")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        EyeSpec spec{.model = EyeModelKind::Paper,
                     .rx = Prescription{.sphere_d = input["S"],
                                        .cylinder_d = input["C"],
                                        .axis_deg = input["axis"]},
                     .rx_plane = RxPlane::EntrancePupil,
                     .eye_length_m = input["d_eye_m"]};
        const V2d chief_slope = pair_of(input["chief_slope"]);
        const V2d pupil_point_m = pair_of(input["pupil_m"]);
        const V2d paper = make_eye(spec)->ray(chief_slope, pupil_point_m, 555.0).slope;
        spec.model = EyeModelKind::Paraxial;
        const V2d exact = make_eye(spec)->ray(chief_slope, pupil_point_m, 555.0).slope;
        expect_slope(paper, vector["expect"]["slope_paper"]);
        expect_slope(exact, vector["expect"]["slope_exact"]);
        test::expect_vector_value(arcmin_from_rad((paper - exact).length()),
                                  vector["expect"]["error_arcmin"]);
    }
}

TEST(PaperEye, with_a_sphere_is_the_paraxial_eye)
{
    for (const double sphere_d : {-30.0, -2.0, 0.0, 3.0, 30.0}) {
        EyeSpec spec{.rx = Prescription{.sphere_d = sphere_d},
                     .rx_plane = RxPlane::EntrancePupil,
                     .accommodation_d = 2.0};
        const V2d exact = make_eye(spec)->ray({0.1, 0.2}, {1e-3, -2e-3}, 555.0).slope;
        spec.model = EyeModelKind::Paper;
        const V2d paper = make_eye(spec)->ray({0.1, 0.2}, {1e-3, -2e-3}, 555.0).slope;
        EXPECT_NEAR((paper - exact).length(), 0.0, 1e-14) << sphere_d << " D";
    }
}

TEST(PaperEye, is_the_same_for_both_forms_of_a_prescription)
{
    const Prescription rx{.sphere_d = 1.0, .cylinder_d = -2.5, .axis_deg = 20.0};
    const auto minus = make_eye({.model = EyeModelKind::Paper, .rx = rx});
    const auto plus = make_eye({.model = EyeModelKind::Paper, .rx = transposed(rx)});
    for (int i = 0; i < 12; ++i) {
        const V2d p = V2d(std::cos(0.5 * i), std::sin(0.5 * i)) * 2e-3;
        EXPECT_NEAR(
            (minus->ray(V2d(0.0), p, 555.0).slope - plus->ray(V2d(0.0), p, 555.0).slope).length(),
            0.0, 1e-15)
            << p;
    }
}

TEST(PaperEye, takes_the_prescription_as_it_is_written)
{
    const auto eye = make_eye({.model = EyeModelKind::Paper,
                               .rx = Prescription{.sphere_d = -10.0},
                               .rx_plane = RxPlane::Spectacle,
                               .vertex_m = 12e-3});
    EXPECT_DOUBLE_EQ(eye->retinal_conjugate_d().xx_d, 10.0);
}

TEST(PaperEye, refuses_a_prescription_that_needs_no_lens)
{
    EXPECT_THROW(static_cast<void>(make_eye({.model = EyeModelKind::Paper,
                                             .rx = Prescription{.sphere_d = 30.0},
                                             .eye_length_m = 33e-3})),
                 std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
