#include "render/camera_motion.h"

#include "scene/motion.h"

#include <Imath/ImathMatrixAlgo.h>

#include <utility>

namespace eye_render {

namespace {

// From camera to world, with a mirrored camera's z turned over.
Imath::Quatd turn_of(const CameraFrame& frame)
{
    const V3d& x = frame.axis_x;
    const V3d y = (frame.axis_y - x * x.dot(frame.axis_y)).normalized();
    const V3d z = x.cross(y);
    return Imath::extractQuat(
        M44d(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1));
}

bool is_mirrored(const CameraFrame& frame)
{
    return frame.axis_x.cross(frame.axis_y).dot(frame.axis_z) < 0.0;
}

}  // namespace

CameraMotion::CameraMotion(std::vector<CameraFrame> poses) : poses_(std::move(poses))
{
    for (const CameraFrame& pose : poses_) {
        turns_.push_back(turn_of(pose));
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
    const auto axes =
        Imath::slerpShortestArc(turns_[place.step], turns_[place.step + 1], weight).toMatrix33();
    const auto axis = [&axes](int i) { return V3d(axes[i][0], axes[i][1], axes[i][2]); };
    frame.axis_x = axis(0);
    frame.axis_y = axis(1);
    frame.axis_z = is_mirrored(before) ? -axis(2) : axis(2);
    frame.slope_left = between(before.slope_left, after.slope_left);
    frame.slope_right = between(before.slope_right, after.slope_right);
    frame.slope_bottom = between(before.slope_bottom, after.slope_bottom);
    frame.slope_top = between(before.slope_top, after.slope_top);
    return frame;
}

}  // namespace eye_render
