#include "analysis/retinal_spot.h"

#include "base/units.h"

#include <cmath>
#include <complex>

namespace eye_render {

std::vector<V2d> retinal_spot_m(const LensSystem& system,
                                double stop_diameter_m,
                                double wavelength_nm)
{
    // Points on a square grid across the cornea. 60000 or so of them pass: the transfer function
    // of a 4 mm stop is then right to 0.0005 up to 100 cycles/mm.
    constexpr int points_across = 320;
    // Wider than any eye's entrance pupil is beside its stop.
    constexpr double widest_magnification = 1.2;
    constexpr double before_eye_m = -10e-3;

    const Indices indices = indices_at(system, wavelength_nm);
    const double radius_m = 0.5 * widest_magnification * stop_diameter_m;
    const auto height_m = [&](int i) {
        return radius_m * ((2.0 * i + 1.0) / points_across - 1.0);
    };
    std::vector<V2d> spot_m;
    for (int i = 0; i < points_across; ++i) {
        for (int j = 0; j < points_across; ++j) {
            const OpticalRay incoming{{height_m(i), height_m(j), before_eye_m}, {0.0, 0.0, 1.0}};
            const TraceResult at_lens = traced_inward(system, indices, incoming, 0, system.lens);
            if (at_lens.fate != TraceFate::Passed) continue;
            const V3d in_stop_m = at_plane(at_lens.ray, system.stop_m).origin_m;
            if (std::hypot(in_stop_m.x, in_stop_m.y) > 0.5 * stop_diameter_m) continue;
            const TraceResult landed = traced_to_retina(system, indices, at_lens.ray, system.lens);
            if (landed.fate != TraceFate::Passed) continue;
            spot_m.emplace_back(landed.ray.origin_m.x, landed.ray.origin_m.y);
        }
    }
    return spot_m;
}

std::vector<double> retinal_mtf(std::span<const V2d> spot_m,
                                std::span<const double> frequencies_per_m)
{
    std::vector<double> mtf;
    for (const double frequency_per_m : frequencies_per_m) {
        std::complex<double> sum = 0.0;
        for (const V2d& point_m : spot_m) {
            sum += std::polar(1.0, 2.0 * pi * frequency_per_m * point_m.x);
        }
        mtf.push_back(spot_m.empty() ? 0.0 : std::abs(sum) / static_cast<double>(spot_m.size()));
    }
    return mtf;
}

}  // namespace eye_render
