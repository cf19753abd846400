#include "render/blur_bound.h"

#include "base/units.h"
#include "optics/display_primaries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
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

// How many units of object-space slope a unit of chief slope spans, the least over directions: 1
// unless the eye looks through a lens.
double least_scale(const EyeModel& eye, const V2d& chief_slope, double object_vergence_d)
{
    constexpr double step = 1e-3;
    const auto slope_of = [&](const V2d& chief) {
        return slope_at(eye.ray(chief, V2d(0.0), reference_wavelength_nm), object_vergence_d);
    };
    const V2d dx = (slope_of(chief_slope + V2d(step, 0.0)) - slope_of(chief_slope)) / step;
    const V2d dy = (slope_of(chief_slope + V2d(0.0, step)) - slope_of(chief_slope)) / step;
    // The smaller singular value of the matrix with these columns.
    const double squares = dx.length2() + dy.length2();
    const double determinant = dx.cross(dy);
    const double discriminant = squares * squares - 4.0 * determinant * determinant;
    return std::sqrt(std::max(0.0, 0.5 * (squares - std::sqrt(std::max(0.0, discriminant)))));
}

// Largest distance from the chief ray, in chief slope; infinite if the eye loses the rays to tell.
// For every ray the distance is convex in the vergence, so the two ends bound what lies between.
double blur_radius(const EyeModel& eye,
                   const V2d& chief_slope,
                   double nearest_vergence_d,
                   double wavelength_nm)
{
    const EyeRay chief = eye.ray(chief_slope, V2d(0.0), reference_wavelength_nm);
    if (chief.fate != RayFate::Transmitted) {
        return std::numeric_limits<double>::infinity();
    }
    double largest = 0.0;
    for (const double vergence_d : {0.0, nearest_vergence_d}) {
        const double scale = least_scale(eye, chief_slope, vergence_d);
        for (int i = 0; i < 2 * rim_points; ++i) {
            const double angle_rad = 2.0 * pi * i / rim_points;
            const double radius_m = eye.pupil_diameter_m() * (i < rim_points ? 0.5 : 0.25);
            const EyeRay ray =
                eye.ray(chief_slope, V2d(std::cos(angle_rad), std::sin(angle_rad)) * radius_m,
                        wavelength_nm);
            if (ray.fate != RayFate::Transmitted) {
                return std::numeric_limits<double>::infinity();
            }
            const V2d off = slope_at(ray, vergence_d) - slope_at(chief, vergence_d);
            largest = std::max(largest, off.length() / scale);
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
