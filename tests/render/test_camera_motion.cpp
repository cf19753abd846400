// The camera between its known poses: straight ways, even turns, zooms.

#include "render/camera_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace eye_render {
namespace {

// At `position`, turned by `angle_rad` about the z axis.
CameraFrame pose(const V3d& position, double angle_rad, double half_slope = 0.5)
{
    CameraFrame frame;
    frame.position_world = position;
    frame.axis_x = {std::cos(angle_rad), std::sin(angle_rad), 0.0};
    frame.axis_y = {-std::sin(angle_rad), std::cos(angle_rad), 0.0};
    frame.slope_left = -half_slope;
    frame.slope_right = half_slope;
    return frame;
}

void expect_near(const V3d& value, const V3d& expected)
{
    EXPECT_LT((value - expected).length(), 1e-12) << value << " is not " << expected;
}

TEST(CameraMotion, passes_through_its_poses)
{
    const std::vector<CameraFrame> poses{pose({0, 0, 0}, 0.0), pose({1, 0, 0}, 0.5),
                                         pose({1, 2, 0}, -0.2)};
    const CameraMotion motion(poses);
    for (std::size_t step = 0; step < poses.size(); ++step) {
        const CameraFrame frame = motion.at(0.5f * static_cast<float>(step));
        expect_near(frame.position_world, poses[step].position_world);
        expect_near(frame.axis_x, poses[step].axis_x);
        expect_near(frame.axis_z, poses[step].axis_z);
    }
}

TEST(CameraMotion, turns_evenly_and_the_short_way)
{
    const CameraMotion motion({pose({0, 0, 0}, 3.0), pose({4, 0, 0}, -3.0)});
    const double way = 2.0 * (std::numbers::pi - 3.0);
    const CameraFrame frame = motion.at(0.25f);
    expect_near(frame.axis_x, pose(V3d(0.0), 3.0 + 0.25 * way).axis_x);
    expect_near(frame.axis_y, pose(V3d(0.0), 3.0 + 0.25 * way).axis_y);
    expect_near(frame.position_world, {1, 0, 0});
}

TEST(CameraMotion, a_mirrored_camera_stays_mirrored)
{
    CameraFrame mirrored = pose({0, 0, 0}, 0.3);
    mirrored.axis_z = -mirrored.axis_z;
    const CameraMotion motion({mirrored, mirrored});
    expect_near(motion.at(0.5f).axis_z, mirrored.axis_z);
    expect_near(motion.at(0.5f).axis_x, mirrored.axis_x);
}

TEST(CameraMotion, a_sheared_camera_stays_sheared)
{
    CameraFrame sheared = pose({0, 0, 0}, 0.3);
    sheared.axis_y = V3d(0.3, 1.0, 0.1).normalized();
    sheared.axis_z = V3d(-0.2, 0.3, 1.0).normalized();
    const CameraMotion motion({sheared, sheared});
    expect_near(motion.at(0.5f).axis_x, sheared.axis_x);
    expect_near(motion.at(0.5f).axis_y, sheared.axis_y);
    expect_near(motion.at(0.5f).axis_z, sheared.axis_z);
}

TEST(CameraMotion, zooms_by_the_slope)
{
    const CameraMotion motion({pose(V3d(0.0), 0.0, 0.2), pose(V3d(0.0), 0.0, 0.6)});
    EXPECT_NEAR(motion.at(0.5f).slope_right, 0.4, 1e-12);
    EXPECT_NEAR(motion.at(0.25f).slope_left, -0.3, 1e-12);
}

}  // namespace
}  // namespace eye_render
