// The peak's place, and the mean over the pupil.

#include "eye/stiles_crawford.h"

#include "base/units.h"

#include <cmath>

namespace eye_render {

namespace {

// By Simpson's rule in the square of the radius and equal steps in angle, for a smooth function:
// to 1e-10 up to a pupil of 9 mm.
double mean_efficiency(const ConeDirectivity& directivity, double pupil_radius_m)
{
    constexpr int rings = 256;  // even
    constexpr int spokes = 32;
    double sum = 0.0;
    for (int ring = 0; ring <= rings; ++ring) {
        const double share = ring == 0 || ring == rings ? 1.0 : (ring % 2 == 0 ? 2.0 : 4.0);
        const double radius_m = pupil_radius_m * std::sqrt(static_cast<double>(ring) / rings);
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double angle_rad = 2.0 * pi * spoke / spokes;
            sum += share * directivity.efficiency(V2d(std::cos(angle_rad), std::sin(angle_rad)) *
                                                  radius_m);
        }
    }
    return sum / (3.0 * rings * spokes);
}

}  // namespace

std::string_view to_string(StilesCrawfordMode mode)
{
    switch (mode) {
    case StilesCrawfordMode::Off: return "OFF";
    case StilesCrawfordMode::Brightness: return "BRIGHTNESS";
    case StilesCrawfordMode::Energy: return "ENERGY";
    }
    return "";
}

double ConeDirectivity::efficiency(const V2d& pupil_point_m) const
{
    const double x_mm = mm_from_m(pupil_point_m.x - peak_m.x);
    const double y_mm = mm_from_m(pupil_point_m.y - peak_m.y);
    return std::pow(10.0, -rho_x_per_mm2 * x_mm * x_mm - rho_y_per_mm2 * y_mm * y_mm);
}

ConeDirectivity cone_directivity(EyeSide eye)
{
    // The patient sees the nose to the left of the right eye.
    const double nasal = eye == EyeSide::Right ? -1.0 : (eye == EyeSide::Left ? 1.0 : 0.0);
    return {.peak_m = {nasal * m_from_mm(0.51), m_from_mm(0.20)}};
}

StilesCrawford::StilesCrawford(const ConeDirectivity& directivity, double pupil_diameter_m)
    : directivity_(directivity),
      effective_area_ratio_(mean_efficiency(directivity, 0.5 * pupil_diameter_m))
{
}

}  // namespace eye_render
