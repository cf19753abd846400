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

TEST(Camera, the_picture_shows_a_point_where_its_chief_ray_comes_from)
{
    CameraFrame frame = test::frame(32, 0.5);
    frame.position_world = V3d(7.0, -3.0, 2.0);
    frame.metres_per_unit = 0.01;
    const std::array eyes{EyeModelKind::Paraxial, EyeModelKind::Navarro};
    for (const EyeModelKind model : eyes) {
        const auto eye = make_eye({.model = model,
                                   .rx = Prescription{.sphere_d = -4.0},
                                   .rx_plane = RxPlane::EntrancePupil,
                                   .pupil_diameter_m = 4e-3});
        for (const V2d& raster : {V2d(16.0, 16.0), V2d(3.25, 28.5), V2d(31.0, 1.0)}) {
            const auto ray = camera_ray(frame, *eye, frame.chief_slope(raster), V2d(0.0));
            ASSERT_EQ(ray.fate, RayFate::Transmitted);
            const V3d p = frame.position_world + V3d(ray.ray.origin + ray.ray.direction * 40.0f);
            const auto found = raster_of(frame, *eye, p);
            ASSERT_TRUE(found);
            EXPECT_LT((*found - raster).length(), 1e-3) << raster;
        }
        EXPECT_FALSE(raster_of(frame, *eye, frame.position_world + frame.axis_z));
    }
}

// A camera under a parent that is scaled unevenly: its axes are unit, but not across each other.
CameraFrame sheared()
{
    CameraFrame frame = test::frame(64, 0.5);
    frame.position_world = V3d(3.0, -1.0, 2.0);
    frame.axis_x = V3d(1.0, 0.2, 0.0).normalized();
    frame.axis_y = V3d(0.3, 1.0, 0.1).normalized();
    frame.axis_z = V3d(-0.2, 0.3, 1.0).normalized();
    return frame;
}

// What Window coordinates say of a place is where the camera shows it.
TEST(Camera, nodes_see_a_sheared_camera_as_its_rays_do)
{
    const CameraFrame frame = sheared();
    const auto eye = make_eye({.model = EyeModelKind::Pinhole});
    for (const V2d& slope : {V2d(0.0), V2d(0.4, -0.3), V2d(-0.2, 0.5)}) {
        const CameraRay seen = camera_ray(frame, *eye, slope, V2d(0.0));
        const V3d p_world = frame.position_world + V3d(seen.ray.direction) * 5.0;
        V3f p_camera;
        view_frame(frame).camera_from_world.multVecMatrix(V3f(p_world), p_camera);
        EXPECT_NEAR(p_camera.x / -p_camera.z, slope.x, 1e-5);
        EXPECT_NEAR(p_camera.y / -p_camera.z, slope.y, 1e-5);
        EXPECT_NEAR(-p_camera.z, seen.depth(5.0), 1e-5);
    }
}

}  // namespace
}  // namespace eye_render
