#include "analysis/pupil_trace.h"

#include "base/sobol.h"
#include "base/warp.h"

namespace eye_render {

namespace {

void count(RayCounts& counts, RayFate fate)
{
    switch (fate) {
    case RayFate::Transmitted: ++counts.transmitted; break;
    case RayFate::Vignetted: ++counts.vignetted; break;
    case RayFate::Missed: ++counts.missed; break;
    case RayFate::TotalReflection: ++counts.total_reflection; break;
    }
}

ObjectLine line_of(const EyeRay& ray)
{
    // Forward is -Z: from z to the pupil's plane at 0 is z of travel.
    const V2d origin_m(ray.origin_eye_m.x, ray.origin_eye_m.y);
    return {.slope = ray.slope, .crossing_m = origin_m + ray.slope * ray.origin_eye_m.z};
}

// Per unit of chief slope along `direction`. Where the ray beside it is lost, as in a picture
// whose slopes are the chief rays'.
ObjectLine change_along(const EyeModel& eye,
                        const ObjectLine& line,
                        const V2d& chief_slope,
                        const V2d& pupil_point_m,
                        double wavelength_nm,
                        const V2d& direction)
{
    // 0.3 arcmin: far below any scale of the field, and far above rounding.
    constexpr double step = 1e-4;
    const EyeRay beside = eye.ray(chief_slope + direction * step, pupil_point_m, wavelength_nm);
    if (beside.fate != RayFate::Transmitted) {
        return {.slope = direction};
    }
    const ObjectLine to = line_of(beside);
    return {.slope = (to.slope - line.slope) / step,
            .crossing_m = (to.crossing_m - line.crossing_m) / step};
}

}  // namespace

PupilTrace trace_pupil(const EyeModel& eye, const PupilTraceOptions& options)
{
    const std::uint64_t key = sobol_key(0, 0);
    const double pupil_radius_m = 0.5 * eye.pupil_diameter_m();
    PupilTrace trace;
    trace.chief_slope = options.chief_slope;
    const EyeRay chief = eye.ray(options.chief_slope, V2d(0.0), reference_wavelength_nm);
    trace.chief = chief.fate == RayFate::Transmitted ? line_of(chief)
                                                     : ObjectLine{.slope = options.chief_slope};
    trace.rays.reserve(options.samples);
    for (std::uint32_t i = 0; i < options.samples; ++i) {
        const auto u = sobol_4d(key, i, 0);
        const V2d pupil_point_m = V2d(sample_uniform_disk({u[0], u[1]})) * pupil_radius_m;
        const EyeRay ray = eye.ray(options.chief_slope, pupil_point_m, options.wavelength_nm);
        count(trace.counts, ray.fate);
        if (ray.fate != RayFate::Transmitted) {
            continue;
        }
        const ObjectLine line = line_of(ray);
        const auto change = [&](const V2d& direction) {
            return change_along(eye, line, options.chief_slope, pupil_point_m,
                                options.wavelength_nm, direction);
        };
        trace.rays.push_back({.pupil_point_m = pupil_point_m,
                              .line = line,
                              .change_x = change({1.0, 0.0}),
                              .change_y = change({0.0, 1.0}),
                              .weight = ray.weight});
    }
    return trace;
}

}  // namespace eye_render
