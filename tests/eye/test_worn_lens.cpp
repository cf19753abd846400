// Eyes behind lenses, against effectivity in closed form and against rays.

#include "eye/eye_factory.h"

#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

const Prescription minus{.sphere_d = -6.0, .cylinder_d = -1.5, .axis_deg = 30.0};
const Prescription plus{.sphere_d = 8.0, .cylinder_d = -2.0, .axis_deg = 160.0};
constexpr double vertex_m = 14e-3;

std::unique_ptr<EyeModel> wearing(const Prescription& rx, const WornLens& lens)
{
    return make_eye({.rx = rx, .vertex_m = vertex_m, .worn = lens});
}

void expect_near(const PowerMatrix& a, const PowerMatrix& b, double tolerance_d)
{
    EXPECT_NEAR(a.xx_d, b.xx_d, tolerance_d);
    EXPECT_NEAR(a.xy_d, b.xy_d, tolerance_d);
    EXPECT_NEAR(a.yy_d, b.yy_d, tolerance_d);
}

constexpr double rounding_d = 1e-12;

TEST(WornLens, glasses_to_the_eyes_own_prescription_leave_no_error_at_infinity)
{
    for (const Prescription& rx : {minus, plus}) {
        expect_near(wearing(rx, glasses(rx, vertex_m))->error_d(0.0), {}, rounding_d);
    }
}

// The strongest lenses: what is near them is magnified most.
TEST(WornLens, tells_what_it_makes_of_the_eyes_own_approximation)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const double sphere_d : {-25.0, 25.0}) {
        EyeSpec spec{.model = EyeModelKind::Navarro, .rx = Prescription{.sphere_d = -4.0}};
        const double bare_arcmin = make_eye(spec)->approximation_arcmin();
        spec.worn = glasses({.sphere_d = sphere_d}, vertex_m);
        const auto fitted = make_eye(spec);
        spec.exact_trace = true;
        const auto exact = make_eye(spec);
        // 17.05 mm before the pupil, which lies 3.05 mm behind the cornea.
        const double gain = std::abs(1.0 - 0.01705 * sphere_d) + 0.00305 * std::abs(sphere_d);
        EXPECT_NEAR(fitted->approximation_arcmin(), gain * bare_arcmin, 1e-12);
        EXPECT_GT(bare_arcmin, 0.0);
        double largest_rad = 0.0;
        for (int i = 0; i < 2000; ++i) {
            const V2d u(0.25 * uniform(random), 0.25 * uniform(random));
            const V2d p_m(1.4e-3 * uniform(random), 1.4e-3 * uniform(random));
            const double nm = 580.0 + 200.0 * uniform(random);
            const V2d off = fitted->ray(u, p_m, nm).slope - exact->ray(u, p_m, nm).slope;
            largest_rad = std::max(largest_rad, off.length());
        }
        EXPECT_LE(arcmin_from_rad(largest_rad), fitted->approximation_arcmin()) << sphere_d;
    }
}

TEST(WornLens, what_is_left_behind_a_wrong_lens_is_the_difference_at_the_pupil)
{
    const Prescription eye{.sphere_d = -4.0, .cylinder_d = -1.0, .axis_deg = 20.0};
    const Prescription lens{.sphere_d = -3.5, .cylinder_d = -2.0, .axis_deg = 75.0};
    const PowerMatrix at_pupil =
        moved_toward_eye(power_matrix_camera(lens), vertex_m + cornea_to_entrance_pupil_m);
    const PowerMatrix left = at_pupil - rx_at_entrance_pupil({.rx = eye, .vertex_m = vertex_m});
    expect_near(wearing(eye, glasses(lens, vertex_m))->error_d(0.0), left, rounding_d);
}

TEST(WornLens, a_contact_lens_is_nearer_and_so_weaker_for_a_myope)
{
    // -10 D at 12 mm is -8.9286 D at the cornea.
    const Prescription at_cornea{.sphere_d = -10.0 / (1.0 + 0.12)};
    const auto eye =
        make_eye({.rx = Prescription{.sphere_d = -10.0}, .worn = contact_lens(at_cornea)});
    expect_near(eye->error_d(0.0), {}, rounding_d);
}

// The error by its meaning: from u0 + E p all rays meet the object's plane in one point.
TEST(WornLens, rays_from_the_blur_meet_at_the_object)
{
    for (const Prescription& rx : {minus, plus}) {
        for (const Prescription& lens : {minus, plus}) {
            const auto eye = wearing(rx, glasses(lens, vertex_m));
            for (const double object_m : {0.03, 0.25, 1.0, 1e7}) {
                SCOPED_TRACE(object_m);
                const PowerMatrix error_d = eye->error_d(1.0 / object_m);
                const V2d u0(0.2, -0.1);
                const auto meets = [&](const V2d& p) {
                    const EyeRay ray = eye->ray(u0 + error_d * p, p, 555.0);
                    const V2d at(ray.origin_eye_m.x, ray.origin_eye_m.y);
                    return at + ray.slope * (object_m + ray.origin_eye_m.z);
                };
                for (const V2d& p : {V2d(2e-3, 0.0), V2d(-1e-3, 3e-3)}) {
                    EXPECT_LT((meets(p) - meets(V2d(0.0))).length(), 1e-13 * (1.0 + object_m));
                }
            }
        }
    }
}

TEST(WornLens, an_object_at_the_lens_is_no_singularity)
{
    const double lens_m = vertex_m + cornea_to_entrance_pupil_m;
    const auto eye = wearing(minus, glasses(plus, vertex_m));
    const auto error_at = [&](double distance_m) { return eye->error_d(1.0 / distance_m).xx_d; };
    EXPECT_NEAR(error_at(lens_m), -1.0 / lens_m + 6.0, 1.0);
    EXPECT_NEAR(error_at(lens_m * (1.0 + 1e-9)), error_at(lens_m * (1.0 - 1e-9)), 1e-4);
}

// Rubin's shape-free power factor 1 / (1 - d F), d to the entrance pupil.
TEST(WornLens, minus_glasses_make_the_world_smaller)
{
    const auto eye = wearing({.sphere_d = -10.0}, glasses({.sphere_d = -10.0}, 12e-3));
    const double magnification = 0.1 / eye->ray({0.1, 0.0}, V2d(0.0), 555.0).slope.x;
    EXPECT_NEAR(magnification, 1.0 / (1.0 + 0.01505 * 10.0), 1e-12);
}

// A prism bends the line of sight towards its base, so what is seen moves towards its apex.
TEST(WornLens, a_prism_shifts_the_picture_and_does_not_blur_it)
{
    const auto slope_through = [](const Prescription& lens, const V2d& pupil_point_m) {
        return wearing({}, glasses(lens, vertex_m))->ray(V2d(0.0), pupil_point_m, 555.0).slope;
    };
    for (const V2d& p : {V2d(0.0), V2d(1e-3, -2e-3)}) {
        EXPECT_EQ(slope_through({.base_up_pd = 2.0}, p), V2d(0.0, 0.02));
        EXPECT_EQ(slope_through({.base_in_pd = 3.0, .eye = EyeSide::Right}, p), V2d(-0.03, 0.0));
        EXPECT_EQ(slope_through({.base_in_pd = 3.0, .eye = EyeSide::Left}, p), V2d(0.03, 0.0));
    }
    EXPECT_THROW((void)glasses({.base_in_pd = 1.0}, vertex_m), std::invalid_argument);
}

TEST(WornLens, glasses_whose_focus_is_the_pupil_are_refused)
{
    EXPECT_THROW((void)glasses({.sphere_d = 30.0, .cylinder_d = 15.0, .axis_deg = 10.0}, 20e-3),
                 std::invalid_argument);
    EXPECT_THROW((void)glasses({.sphere_d = -1.0}, 0.05), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
