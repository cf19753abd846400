// From a pixel to a ray: the frame of the picture in slope space, the eye that looks through it,
// and the one place where the eye's doubles become the scene's floats.
//
// World space is relative to the eye: only the camera's axes enter, never its position.

#pragma once

#include "base/vector.h"
#include "eye/eye_model.h"
#include "optics/chromatic.h"
#include "scene/ray.h"
#include "shading/hit_attributes.h"

#include <optional>

namespace eye_render {

// A window of the frame in pixels, `x1` and `y1` excluded, y counted from the bottom.
struct PixelBounds {
    int x0 = 0;
    int y0 = 0;
    int x1 = 0;
    int y1 = 0;

    [[nodiscard]] int width() const { return x1 - x0; }
    [[nodiscard]] int height() const { return y1 - y0; }
};

struct CameraFrame {
    V3d position_world{0.0};  // scene units
    // Unit axes of the camera in the world; the camera looks along -axis_z. Under a parent that is
    // scaled unevenly they are not across each other: as in Cycles, rays and slopes go along the
    // axes as they are, and the way back is by the inverse.
    V3d axis_x{1.0, 0.0, 0.0};
    V3d axis_y{0.0, 1.0, 0.0};
    V3d axis_z{0.0, 0.0, 1.0};
    // The full frame's edges as slopes.
    double slope_left = -0.5;
    double slope_right = 0.5;
    double slope_bottom = -0.5;
    double slope_top = 0.5;
    int width_px = 0;
    int height_px = 0;
    PixelBounds border;      // what is rendered
    double clip_near = 0.0;  // distances along the viewing axis, scene units
    double clip_far = 0.0;
    double metres_per_unit = 1.0;

    // Slope of a raster position; pixel (0, 0) is at the lower left, its centre at (0.5, 0.5).
    [[nodiscard]] V2d chief_slope(const V2d& raster) const;
    [[nodiscard]] V2d pixel_slope_size() const;
    [[nodiscard]] M44d camera_from_world() const;
};

// Throws std::invalid_argument for a number out of range.
void validate(const CameraFrame& frame);

// As nodes see the camera.
[[nodiscard]] ViewFrame view_frame(const CameraFrame& frame);

struct CameraRay {
    RayFate fate = RayFate::Transmitted;  // if another, the rest means nothing
    Ray ray;
    V2d slope{0.0};  // in object space, camera frame
    double weight = 1.0;
    // Along the viewing axis, scene units: a point at `t` is as far as `depth(t)`.
    double origin_depth = 0.0;
    double length_per_depth = 1.0;

    [[nodiscard]] double depth(double t) const { return origin_depth + t / length_per_depth; }
};

// The ray of the picture element with chief slope `chief_slope` through `pupil_point_m`.
[[nodiscard]] CameraRay camera_ray(const CameraFrame& frame,
                                   const EyeModel& eye,
                                   const V2d& chief_slope,
                                   const V2d& pupil_point_m,
                                   double wavelength_nm = reference_wavelength_nm);

// Where in the picture the eye sees the point of the world through its pupil's centre; nothing if
// it does not.
[[nodiscard]] std::optional<V2d> raster_of(const CameraFrame& frame,
                                           const EyeModel& eye,
                                           const V3d& p_world);

}  // namespace eye_render
