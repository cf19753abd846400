#include "render/camera.h"

#include <cmath>

namespace eye_render {

namespace {

// Where the eye's efficiency peaks; the monochromatic trace stands for all three channels.
constexpr double reference_wavelength_nm = 555.0;

}  // namespace

V2d CameraFrame::chief_slope(const V2d& raster) const
{
    return {slope_left + (slope_right - slope_left) * raster.x / width_px,
            slope_bottom + (slope_top - slope_bottom) * raster.y / height_px};
}

V2d CameraFrame::pixel_slope_size() const
{
    return {(slope_right - slope_left) / width_px, (slope_top - slope_bottom) / height_px};
}

std::optional<CameraRay> camera_ray(const CameraFrame& frame,
                                    const EyeModel& eye,
                                    const V2d& chief_slope,
                                    const V2d& pupil_point_m)
{
    const EyeRay seen = eye.ray(chief_slope, pupil_point_m, reference_wavelength_nm);
    if (seen.fate != RayFate::Transmitted) {
        return std::nullopt;
    }
    const auto to_world = [&frame](const V3d& v) {
        return frame.axis_x * v.x + frame.axis_y * v.y + frame.axis_z * v.z;
    };
    const V3d origin = to_world(seen.origin_eye_m / frame.metres_per_unit);
    const V3d towards = to_world({seen.slope.x, seen.slope.y, -1.0});
    // Clipping planes are perpendicular to the axis; a ray at a slope travels longer to reach
    // them.
    const double length_per_depth = towards.length();
    CameraRay result;
    result.slope = seen.slope;
    result.weight = seen.weight;
    result.ray.origin = V3f(origin);
    result.ray.direction = V3f(towards / length_per_depth);
    result.ray.t_min = static_cast<float>(frame.clip_near * length_per_depth);
    result.ray.t_max = static_cast<float>(frame.clip_far * length_per_depth);
    return result;
}

}  // namespace eye_render
