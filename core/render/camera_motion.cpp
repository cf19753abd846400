#include "render/camera_motion.h"

#include "scene/motion.h"

#include <Imath/ImathMatrixAlgo.h>

#include <utility>

namespace eye_render {

namespace {

using Axes = Imath::M33d;  // one a row

Axes axes_of(const CameraFrame& frame)
{
    const V3d& x = frame.axis_x;
    const V3d& y = frame.axis_y;
    const V3d& z = frame.axis_z;
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

// The axes as if they were across each other and right-handed: x as it is, y in the plane of both.
Axes upright(const CameraFrame& frame)
{
    const V3d& x = frame.axis_x;
    const V3d y = (frame.axis_y - x * x.dot(frame.axis_y)).normalized();
    const V3d z = x.cross(y);
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

Imath::Quatd turn_of(const Axes& axes)
{
    M44d matrix;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            matrix[i][j] = axes[i][j];
        }
    }
    return Imath::extractQuat(matrix);
}

}  // namespace

CameraMotion::CameraMotion(std::vector<CameraFrame> poses) : poses_(std::move(poses))
{
    for (const CameraFrame& pose : poses_) {
        const Axes turned = upright(pose);
        turns_.push_back(turn_of(turned));
        shears_.push_back(axes_of(pose) * turned.transposed());
    }
}

CameraFrame CameraMotion::at(float time) const
{
    const MotionPlace place = motion_place(poses_.size(), time);
    const CameraFrame& before = poses_[place.step];
    const CameraFrame& after = poses_[place.step + 1];
    const auto weight = static_cast<double>(place.weight);
    const auto between = [weight](const auto& a, const auto& b) {
        return a * (1.0 - weight) + b * weight;
    };
    CameraFrame frame = before;
    frame.position_world = between(before.position_world, after.position_world);
    const Axes axes =
        between(shears_[place.step], shears_[place.step + 1]) *
        Imath::slerpShortestArc(turns_[place.step], turns_[place.step + 1], weight).toMatrix33();
    const auto axis = [&axes](int i) { return V3d(axes[i][0], axes[i][1], axes[i][2]); };
    frame.axis_x = axis(0);
    frame.axis_y = axis(1);
    frame.axis_z = axis(2);
    frame.slope_left = between(before.slope_left, after.slope_left);
    frame.slope_right = between(before.slope_right, after.slope_right);
    frame.slope_bottom = between(before.slope_bottom, after.slope_bottom);
    frame.slope_top = between(before.slope_top, after.slope_top);
    return frame;
}

}  // namespace eye_render
