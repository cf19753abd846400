#include "render/camera.h"

#include "base/error.h"
#include "scene/transform.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

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

M44d CameraFrame::camera_from_world() const
{
    const std::array axes{axis_x, axis_y, axis_z, position_world};
    M44d world_from_camera;
    for (std::size_t row = 0; row < axes.size(); ++row) {
        for (int i = 0; i < 3; ++i) {
            world_from_camera[static_cast<int>(row)][i] = axes[row][i];
        }
    }
    return world_from_camera.inverse();
}

void validate(const CameraFrame& frame)
{
    // Also refuses NaN. A sheared parent may tilt the axes against each other, but not flatten
    // them.
    if (!(std::abs(frame.axis_x.dot(frame.axis_y.cross(frame.axis_z))) > 1e-6)) {
        throw std::invalid_argument(
            "the camera's axes span no space; expected an invertible matrix");
    }
    for (const double coordinate :
         {frame.position_world.x, frame.position_world.y, frame.position_world.z}) {
        require_range("camera position", coordinate, -1e30, 1e30, "units");
    }
    require_range("resolution x", frame.width_px, 1, 65536, "px");
    require_range("resolution y", frame.height_px, 1, 65536, "px");
    require_range("border x0", frame.border.x0, 0, frame.width_px - 1, "px");
    require_range("border y0", frame.border.y0, 0, frame.height_px - 1, "px");
    require_range("border x1", frame.border.x1, frame.border.x0 + 1, frame.width_px, "px");
    require_range("border y1", frame.border.y1, frame.border.y0 + 1, frame.height_px, "px");
    // 1e4 is a field of view of 179.99 degrees: wider is no perspective camera.
    require_range("slope_left", frame.slope_left, -1e4, 1e4, "");
    require_range("slope_bottom", frame.slope_bottom, -1e4, 1e4, "");
    require_range("slope_right", frame.slope_right, frame.slope_left + 1e-9, 1e4, "");
    require_range("slope_top", frame.slope_top, frame.slope_bottom + 1e-9, 1e4, "");
    require_range("clip near", frame.clip_near, 0.0, 1e30, "units");
    require_range("clip far", frame.clip_far, frame.clip_near, 1e30, "units");
    require_range("metres_per_unit", frame.metres_per_unit, 1e-9, 1e9, "m");
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

std::optional<V2d> raster_of(const CameraFrame& frame, const EyeModel& eye, const V3d& p_world)
{
    const Imath::M33d world_from_camera(frame.axis_x.x, frame.axis_x.y, frame.axis_x.z,  //
                                        frame.axis_y.x, frame.axis_y.y, frame.axis_y.z,  //
                                        frame.axis_z.x, frame.axis_z.y, frame.axis_z.z);
    const V3d p_eye_m =
        (p_world - frame.position_world) * world_from_camera.inverse() * frame.metres_per_unit;
    if (!(p_eye_m.z < 0.0)) {
        return std::nullopt;
    }
    // An eye bends rays by little: where its ray passes the point says by how much to aim anew.
    constexpr int most_aims = 16;
    constexpr double aimed_px = 1e-4;
    V2d slope(p_eye_m.x / -p_eye_m.z, p_eye_m.y / -p_eye_m.z);
    for (int aim = 0; aim < most_aims; ++aim) {
        const EyeRay seen = eye.ray(slope, V2d(0.0), reference_wavelength_nm);
        if (seen.fate != RayFate::Transmitted) {
            return std::nullopt;
        }
        const double way_m = seen.origin_eye_m.z - p_eye_m.z;
        const V2d beside(p_eye_m.x - seen.origin_eye_m.x - seen.slope.x * way_m,
                         p_eye_m.y - seen.origin_eye_m.y - seen.slope.y * way_m);
        const V2d correction = beside / way_m;
        slope += correction;
        if (correction.length() < aimed_px * frame.pixel_slope_size().x) {
            break;
        }
    }
    return V2d((slope.x - frame.slope_left) / frame.pixel_slope_size().x,
               (slope.y - frame.slope_bottom) / frame.pixel_slope_size().y);
}

ViewFrame view_frame(const CameraFrame& frame)
{
    ViewFrame view;
    view.camera_from_world = to_float(frame.camera_from_world());
    view.slope_first = {static_cast<float>(frame.slope_left),
                        static_cast<float>(frame.slope_bottom)};
    view.slope_last = {static_cast<float>(frame.slope_right), static_cast<float>(frame.slope_top)};
    return view;
}

}  // namespace eye_render
