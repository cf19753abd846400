// What the tests of scattering share: directions, and integrals over all directions by the
// midpoint rule, which know nothing of how a BSDF samples.

#pragma once

#include "base/units.h"
#include "shading/bsdf.h"

#include <algorithm>
#include <cmath>

namespace eye_render::test {

inline const V3f up(0.0f, 0.0f, 1.0f);

// Unit, at this angle from +Z, towards +X and turned by `azimuth_deg`.
[[nodiscard]] inline V3f direction_at(double angle_deg, double azimuth_deg = 0.0)
{
    const double theta = rad_from_deg(angle_deg);
    const double phi = rad_from_deg(azimuth_deg);
    return V3f(
        V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)));
}

// Calls visit(wi, solid angle) for the midpoints of cells of the sphere, of equal sides in polar
// angle and azimuth.
template <typename Visit>
void for_each_direction(int heights, int azimuths, Visit&& visit)
{
    const double step = pi / heights;
    for (int i = 0; i < heights; ++i) {
        const double theta = (i + 0.5) * step;
        const double cell = 2.0 * std::sin(theta) * std::sin(0.5 * step) * 2.0 * pi / azimuths;
        for (int j = 0; j < azimuths; ++j) {
            const double phi = 2.0 * pi * (j + 0.5) / azimuths;
            visit(V3f(V3d(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                          std::cos(theta))),
                  cell);
        }
    }
}

// Which of as many such cells a direction lies in.
[[nodiscard]] inline std::size_t cell_of(const V3f& w, int heights, int azimuths)
{
    const double polar = std::acos(std::clamp(double(w.z), -1.0, 1.0)) / pi;
    const double turn = std::atan2(double(w.y), double(w.x)) / (2.0 * pi);
    const int height = std::min(int(polar * heights), heights - 1);
    const int azimuth = std::min(int((turn - std::floor(turn)) * azimuths), azimuths - 1);
    return std::size_t(height * azimuths + azimuth);
}

struct SphereIntegral {
    V3d value{0.0};  // the directional albedo
    double pdf = 0.0;
};

[[nodiscard]] inline SphereIntegral integrate(const Bsdf& bsdf, int heights = 512)
{
    SphereIntegral sum;
    for_each_direction(heights, heights / 2, [&](const V3f& wi, double solid_angle) {
        const BsdfValue f = bsdf.evaluate(wi);
        sum.value += V3d(f.value.x, f.value.y, f.value.z) * solid_angle;
        sum.pdf += double(f.pdf) * solid_angle;
    });
    return sum;
}

[[nodiscard]] inline bool is_finite(const Color3f& c)
{
    return std::isfinite(c.x) && std::isfinite(c.y) && std::isfinite(c.z);
}

}  // namespace eye_render::test
