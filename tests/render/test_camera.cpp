#include "render/camera.h"

#include "eye/eye_factory.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

std::unique_ptr<const EyeModel> myope(double sphere_d)
{
    return make_eye({.model = EyeModelKind::Paraxial,
                     .rx = Prescription{.sphere_d = sphere_d},
                     .rx_plane = RxPlane::EntrancePupil,
                     .pupil_diameter_m = 4e-3});
}

TEST(Camera, pixel_centres_divide_the_window_of_slopes)
{
    const CameraFrame frame = test::frame(4, 0.5);
    EXPECT_EQ(frame.chief_slope(V2d(0.5, 3.5)), V2d(-0.375, 0.375));
    EXPECT_EQ(frame.pixel_slope_size(), V2d(0.25, 0.25));
}

TEST(Camera, rays_of_a_myope_meet_at_the_far_point)
{
    CameraFrame frame = test::frame(4, 0.5);
    frame.metres_per_unit = 0.01;  // a scene in centimetres
    const auto eye = myope(-2.0);
    const V2d slope(0.1, -0.2);
    for (const V2d& p : {V2d(0.002, 0.0), V2d(-0.001, 0.0015), V2d(0.0, 0.0)}) {
        const auto ray = camera_ray(frame, *eye, slope, p);
        ASSERT_EQ(ray.fate, RayFate::Transmitted);
        // Far point of 2 D: 0.5 m, which is 50 units here; floats hold 50 to 4e-6.
        const V3f at = ray.ray.origin + ray.ray.direction * (-50.0f / ray.ray.direction.z);
        EXPECT_NEAR(at.x, 5.0f, 1e-4f) << "pupil point " << p.x << ", " << p.y;
        EXPECT_NEAR(at.y, -10.0f, 1e-4f);
    }
}

TEST(Camera, clipping_planes_are_perpendicular_to_the_axis)
{
    CameraFrame frame = test::frame(4, 1.0);
    frame.clip_near = 2.0;
    frame.clip_far = 10.0;
    const auto ray = camera_ray(frame, *myope(0.0), V2d(1.0, 0.0), V2d(0.0));
    ASSERT_EQ(ray.fate, RayFate::Transmitted);
    EXPECT_NEAR(ray.ray.t_min, 2.0 * std::sqrt(2.0), 1e-5);
    EXPECT_NEAR(ray.ray.t_max, 10.0 * std::sqrt(2.0), 1e-5);
}

}  // namespace
}  // namespace eye_render
