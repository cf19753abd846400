#include "analysis/pupil_trace.h"

#include "base/sobol.h"
#include "base/warp.h"

#include <array>

namespace eye_render {

namespace {

constexpr double reference_nm = 555.0;

void count(RayCounts& counts, RayFate fate)
{
    switch (fate) {
    case RayFate::Transmitted: ++counts.transmitted; break;
    case RayFate::Vignetted: ++counts.vignetted; break;
    case RayFate::Missed: ++counts.missed; break;
    case RayFate::TotalReflection: ++counts.total_reflection; break;
    }
}

TracedRay traced(const EyeRay& ray, const V2d& pupil_point_m)
{
    // Forward is -Z: from z to the pupil's plane at 0 is z of travel.
    const V2d origin_m(ray.origin_eye_m.x, ray.origin_eye_m.y);
    return {.pupil_point_m = pupil_point_m,
            .slope = ray.slope,
            .crossing_m = origin_m + ray.slope * ray.origin_eye_m.z,
            .weight = ray.weight};
}

TracedRay change(const TracedRay& from, const TracedRay& to, double chief_slope_change)
{
    TracedRay change;
    change.slope = (to.slope - from.slope) / chief_slope_change;
    change.crossing_m = (to.crossing_m - from.crossing_m) / chief_slope_change;
    return change;
}

void trace_chief(PupilTrace& trace, const EyeModel& eye)
{
    // Central differences: 17 arcmin to each side is far below any scale of the field, and far
    // above rounding.
    constexpr double step = 5e-3;
    constexpr std::array<std::array<double, 2>, 5> steps{
        {{0.0, 0.0}, {-step, 0.0}, {step, 0.0}, {0.0, -step}, {0.0, step}}};

    std::array<TracedRay, steps.size()> chiefs;
    bool all_transmitted = true;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const V2d slope = trace.chief_slope + V2d(steps[i][0], steps[i][1]);
        const EyeRay ray = eye.ray(slope, V2d(0.0), reference_nm);
        all_transmitted = all_transmitted && ray.fate == RayFate::Transmitted;
        chiefs[i] = traced(ray, V2d(0.0));
    }
    if (all_transmitted) {
        trace.chief = chiefs[0];
        trace.change_x = change(chiefs[1], chiefs[2], 2.0 * step);
        trace.change_y = change(chiefs[3], chiefs[4], 2.0 * step);
    } else {
        trace.chief.slope = trace.chief_slope;
        trace.change_x.slope = {1.0, 0.0};
        trace.change_y.slope = {0.0, 1.0};
    }
}

}  // namespace

PupilTrace trace_pupil(const EyeModel& eye, const PupilTraceOptions& options)
{
    const std::uint64_t key = sobol_key(0, 0);
    const double pupil_radius_m = 0.5 * eye.pupil_diameter_m();
    PupilTrace trace;
    trace.chief_slope = options.chief_slope;
    trace_chief(trace, eye);
    trace.rays.reserve(options.samples);
    for (std::uint32_t i = 0; i < options.samples; ++i) {
        const auto u = sobol_4d(key, i, 0);
        const V2d pupil_point_m = V2d(sample_uniform_disk({u[0], u[1]})) * pupil_radius_m;
        const EyeRay ray = eye.ray(options.chief_slope, pupil_point_m, options.wavelength_nm);
        count(trace.counts, ray.fate);
        if (ray.fate == RayFate::Transmitted) {
            trace.rays.push_back(traced(ray, pupil_point_m));
        }
    }
    return trace;
}

}  // namespace eye_render
