#include "render/camera.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

V2d CameraFrame::chief_slope(const V2d& raster) const
{
    return {slope_left + (slope_right - slope_left) * raster.x / width_px,
            slope_bottom + (slope_top - slope_bottom) * raster.y / height_px};
}

V2d CameraFrame::pixel_slope_size() const
{
    return {(slope_right - slope_left) / width_px, (slope_top - slope_bottom) / height_px};
}

CameraRay camera_ray(const CameraFrame& frame,
                     const EyeModel& eye,
                     const V2d& chief_slope,
                     const V2d& pupil_point_m,
                     double wavelength_nm)
{
    const EyeRay seen = eye.ray(chief_slope, pupil_point_m, wavelength_nm);
    CameraRay result;
    result.fate = seen.fate;
    if (seen.fate != RayFate::Transmitted) {
        return result;
    }
    const auto to_world = [&frame](const V3d& v) {
        return frame.axis_x * v.x + frame.axis_y * v.y + frame.axis_z * v.z;
    };
    const V3d origin_eye = seen.origin_eye_m / frame.metres_per_unit;
    const V3d towards = to_world({seen.slope.x, seen.slope.y, -1.0});
    result.slope = seen.slope;
    result.weight = seen.weight;
    result.origin_depth = -origin_eye.z;
    // Clipping planes are perpendicular to the axis; a ray at a slope travels longer to reach
    // them.
    result.length_per_depth = towards.length();
    const auto t_at = [&result](double depth) {
        return static_cast<float>((depth - result.origin_depth) * result.length_per_depth);
    };
    result.ray.origin = V3f(to_world(origin_eye));
    result.ray.direction = V3f(towards / result.length_per_depth);
    result.ray.t_min = std::max(0.0f, t_at(frame.clip_near));
    result.ray.t_max = t_at(frame.clip_far);
    return result;
}

ViewFrame view_frame(const CameraFrame& frame)
{
    ViewFrame view;
    const std::array axes{frame.axis_x, frame.axis_y, frame.axis_z};
    for (int axis = 0; axis < 3; ++axis) {
        const V3d& direction = axes[static_cast<std::size_t>(axis)];
        for (int i = 0; i < 3; ++i) {
            view.camera_from_world[i][axis] = static_cast<float>(direction[i]);
        }
        view.camera_from_world[3][axis] = static_cast<float>(-frame.position_world.dot(direction));
    }
    view.slope_first = {static_cast<float>(frame.slope_left),
                        static_cast<float>(frame.slope_bottom)};
    view.slope_last = {static_cast<float>(frame.slope_right), static_cast<float>(frame.slope_top)};
    return view;
}

}  // namespace eye_render
