#include "render/blur_bound.h"

#include "base/units.h"
#include "optics/display_primaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace eye_render {

namespace {

constexpr int rim_points = 32;

// Where a ray meets the plane of an object at vergence X, as a slope from the pupil's centre.
V2d slope_at(const EyeRay& ray, double object_vergence_d)
{
    return V2d(ray.origin_eye_m.x, ray.origin_eye_m.y) * object_vergence_d +
           ray.slope * (1.0 + ray.origin_eye_m.z * object_vergence_d);
}

// Largest distance from the chief ray. For every ray the distance is convex in the vergence, so
// the two ends bound what lies between.
double blur_radius(const EyeModel& eye,
                   const V2d& chief_slope,
                   double nearest_vergence_d,
                   double wavelength_nm)
{
    const EyeRay chief = eye.ray(chief_slope, V2d(0.0), reference_wavelength_nm);
    double largest = 0.0;
    for (int i = 0; i < 2 * rim_points; ++i) {
        const double angle_rad = 2.0 * pi * i / rim_points;
        const double radius_m = eye.pupil_diameter_m() * (i < rim_points ? 0.5 : 0.25);
        const EyeRay ray = eye.ray(
            chief_slope, V2d(std::cos(angle_rad), std::sin(angle_rad)) * radius_m, wavelength_nm);
        if (ray.fate != RayFate::Transmitted || chief.fate != RayFate::Transmitted) {
            continue;
        }
        for (const double vergence_d : {0.0, nearest_vergence_d}) {
            largest = std::max(largest,
                               (slope_at(ray, vergence_d) - slope_at(chief, vergence_d)).length());
        }
    }
    return largest;
}

}  // namespace

double largest_blur_slope(const EyeModel& eye,
                          const CameraFrame& frame,
                          double nearest_m,
                          bool chromatic)
{
    const std::array fields{
        V2d(0.5 * (frame.slope_left + frame.slope_right),
            0.5 * (frame.slope_bottom + frame.slope_top)),
        V2d(frame.slope_left, frame.slope_bottom), V2d(frame.slope_right, frame.slope_bottom),
        V2d(frame.slope_left, frame.slope_top), V2d(frame.slope_right, frame.slope_top)};
    std::vector<double> wavelengths_nm{reference_wavelength_nm};
    if (chromatic) {
        wavelengths_nm.insert(wavelengths_nm.end(), {min_display_nm, max_display_nm});
    }
    double largest = 0.0;
    for (const V2d& field : fields) {
        for (const double wavelength_nm : wavelengths_nm) {
            largest = std::max(largest, blur_radius(eye, field, 1.0 / nearest_m, wavelength_nm));
        }
    }
    return 2.0 * largest;
}

}  // namespace eye_render
