// The paraxial eye against the vectors and against an ideal thin lens.

#include "eye/eye_factory.h"

#include "../optics_vectors.h"

namespace eye_render {
namespace {

using test::Json;

std::unique_ptr<EyeModel> paraxial_eye(const Prescription& rx, double accommodation_d)
{
    return make_eye({.model = EyeModelKind::Paraxial,
                     .rx = rx,
                     .rx_plane = RxPlane::EntrancePupil,
                     .accommodation_d = accommodation_d});
}

TEST(ParaxialEye, sends_rays_as_the_vectors)
{
    for (const Json& vector : test::vectors_of_kind("ray_slope")) {
        EYE_TRACE_VECTOR(vector);
        const Json& input = vector["input"];
        const auto eye = paraxial_eye(
            {.sphere_d = input["S"], .cylinder_d = input["C"], .axis_deg = input["axis"]},
            input["accommodation_D"]);
        const V2d pupil_point_m(input["pupil_m"][0], input["pupil_m"][1]);
        const EyeRay ray =
            eye->ray({input["chief_slope"][0], input["chief_slope"][1]}, pupil_point_m, 555.0);
        test::expect_vector_value(ray.slope.x, vector["expect"]["slope"][0]);
        test::expect_vector_value(ray.slope.y, vector["expect"]["slope"][1]);
        EXPECT_EQ(ray.origin_eye_m, V3d(pupil_point_m.x, pupil_point_m.y, 0.0));
    }
}

TEST(ParaxialEye, with_a_sphere_is_a_thin_lens_focused_on_its_conjugate_plane)
{
    // An eye of -2.5 D that accommodates 1.5 D is focused at 1/4 m: all rays of a pixel meet
    // there.
    const auto eye = paraxial_eye({.sphere_d = -2.5}, 1.5);
    const V2d chief_slope(0.3, -0.1);
    for (const V2d& p : {V2d(2e-3, 0.0), V2d(-1e-3, 1e-3), V2d(0.0, -2e-3)}) {
        const V2d meets_m = p + eye->ray(chief_slope, p, 555.0).slope * 0.25;
        EXPECT_NEAR(meets_m.x, chief_slope.x * 0.25, 1e-15) << p;
        EXPECT_NEAR(meets_m.y, chief_slope.y * 0.25, 1e-15) << p;
    }
}

TEST(ParaxialEye, a_relaxed_emmetrope_returns_the_chief_slope_bit_for_bit)
{
    const V2d chief_slope(0.1, 1.0 / 3.0);
    EXPECT_EQ(paraxial_eye({}, 0.0)->ray(chief_slope, {1e-3, 2e-3}, 555.0).slope, chief_slope);
}

TEST(ParaxialEye, a_cylinder_of_axis_30_is_mirrored_into_the_patients_view)
{
    // -6 x 30: no power along the axis, which the patient sees at 150 degrees.
    const auto eye = paraxial_eye({.cylinder_d = -6.0, .axis_deg = 30.0}, 0.0);
    const double along_rad = 150.0 * std::acos(-1.0) / 180.0;
    const V2d along(std::cos(along_rad), std::sin(along_rad));
    const V2d across(-along.y, along.x);
    EXPECT_NEAR(eye->ray(V2d(0.0), along * 1e-3, 555.0).slope.length(), 0.0, 1e-15);
    EXPECT_NEAR(eye->ray(V2d(0.0), across * 1e-3, 555.0).slope.length(), 6e-3, 1e-15);
}

TEST(ParaxialEye, is_too_strong_in_the_blue_and_as_prescribed_at_555_nm)
{
    // Thibos et al. 1992, vector F02: at 450 nm the correcting lens is 0.8271 D weaker, and K
    // stronger.
    const auto eye = paraxial_eye({.sphere_d = -1.0, .cylinder_d = -0.5, .axis_deg = 30.0}, 0.0);
    const V2d p(1e-3, -2e-3);
    EXPECT_EQ(eye->ray(V2d(0.0), p, 555.0).slope, V2d(0.0) - eye->retinal_conjugate_d() * p);
    const V2d change = eye->ray(V2d(0.0), p, 450.0).slope - eye->ray(V2d(0.0), p, 555.0).slope;
    EXPECT_NEAR(change.x, -0.8271033567246555 * p.x, 1e-15);
    EXPECT_NEAR(change.y, -0.8271033567246555 * p.y, 1e-15);
}

TEST(ParaxialEye, is_finite_at_the_extremes)
{
    for (const double sphere_d : {-30.0, 30.0}) {
        for (const double cylinder_d : {-15.0, 15.0}) {
            const auto eye = make_eye({.rx = Prescription{.sphere_d = sphere_d,
                                                          .cylinder_d = cylinder_d,
                                                          .axis_deg = 30.0},
                                       .vertex_m = 14e-3,
                                       .pupil_diameter_m = 9e-3,
                                       .accommodation_d = 20.0});
            const EyeRay ray = eye->ray({50.0, -50.0}, {4.5e-3, 0.0}, 555.0);
            EXPECT_TRUE(std::isfinite(ray.slope.x) && std::isfinite(ray.slope.y));
            EXPECT_EQ(ray.fate, RayFate::Transmitted);
            const EyeRay invisible = eye->ray({50.0, -50.0}, {4.5e-3, 0.0}, 214.102);
            EXPECT_TRUE(std::isfinite(invisible.slope.x));
        }
    }
}

}  // namespace
}  // namespace eye_render
