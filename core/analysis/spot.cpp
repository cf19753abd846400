// Pupil samples are Owen-scrambled Sobol points under a fixed key: the same spot every time.

#include "analysis/spot.h"

#include "base/sobol.h"
#include "base/warp.h"

namespace eye_render {

SpotMoments spot_moments(const EyeModel& eye, const SpotOptions& options)
{
    const std::uint64_t key = sobol_key(0, 0);
    const double pupil_radius_m = 0.5 * eye.pupil_diameter_m();
    SpotMoments sum;
    for (std::uint32_t i = 0; i < options.samples; ++i) {
        const auto u = sobol_4d(key, i, 0);
        const V2d pupil_point_m = V2d(sample_uniform_disk({u[0], u[1]})) * pupil_radius_m;
        const EyeRay ray = eye.ray(options.chief_slope, pupil_point_m, options.wavelength_nm);
        if (ray.fate != RayFate::Transmitted) {
            continue;
        }
        // Where the ray meets the object's plane, seen from the centre of the pupil.
        const V2d origin_m(ray.origin_eye_m.x, ray.origin_eye_m.y);
        const V2d offset = ray.slope - options.chief_slope + origin_m * options.object_vergence_d;
        sum.transmitted += ray.weight;
        sum.mean += offset * ray.weight;
        sum.xx += ray.weight * offset.x * offset.x;
        sum.xy += ray.weight * offset.x * offset.y;
        sum.yy += ray.weight * offset.y * offset.y;
    }
    if (sum.transmitted <= 0.0) {
        return {};
    }
    const double scale = 1.0 / sum.transmitted;
    const V2d mean = sum.mean * scale;
    return {.mean = mean,
            .xx = sum.xx * scale - mean.x * mean.x,
            .xy = sum.xy * scale - mean.x * mean.y,
            .yy = sum.yy * scale - mean.y * mean.y,
            .transmitted = sum.transmitted / options.samples};
}

}  // namespace eye_render
