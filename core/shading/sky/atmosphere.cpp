#include "shading/sky/atmosphere.h"

#include "base/units.h"
#include "shading/sky/spectra.h"

#include <array>
#include <cmath>

namespace eye_render {

namespace {

constexpr double earth_radius_m = 6360e3;
constexpr double air_radius_m = 6420e3;
constexpr double air_scale_height_m = 8000.0;
constexpr double dust_scale_height_m = 1200.0;
constexpr double dust_scattering_per_m = 2e-5;
constexpr double dust_extinction_per_m = 1.11 * dust_scattering_per_m;
constexpr double dust_asymmetry = 0.76;

// Of air, dust and ozone: densities relative to the densest, or such densities times metres.
using Constituents = V3d;

// Ozone rises from 10 km to 25 km and falls to 40 km.
[[nodiscard]] Constituents densities(const V3d& p_m)
{
    const double height_m = p_m.length() - earth_radius_m;
    constexpr double ozone_middle_m = 25e3;
    constexpr double ozone_half_width_m = 15e3;
    const double ozone = 1.0 - std::abs(height_m - ozone_middle_m) / ozone_half_width_m;
    return {std::exp(-height_m / air_scale_height_m), std::exp(-height_m / dust_scale_height_m),
            std::max(ozone, 0.0)};
}

// Solves |p + t d| = radius for the way out.
[[nodiscard]] double distance_through_air_m(const V3d& p_m, const V3d& direction)
{
    const double half_b = direction.dot(p_m);
    const double c = p_m.dot(p_m) - air_radius_m * air_radius_m;
    return std::sqrt(std::max(half_b * half_b - c, 0.0)) - half_b;
}

[[nodiscard]] bool meets_earth(const V3d& p_m, const V3d& direction)
{
    if (direction.z >= 0.0) {
        return false;
    }
    const double half_b = direction.dot(p_m);
    return half_b * half_b >= p_m.dot(p_m) - earth_radius_m * earth_radius_m;
}

// Density along the way out of the air. It falls off about exponentially, as Gauss-Laguerre
// quadrature likes it: 8 nodes and weights of Abramowitz & Stegun 1964, table 25.9, the way being
// 25 long in their measure.
[[nodiscard]] Constituents column_m(const V3d& p_m, const V3d& direction)
{
    struct Node {
        double place;
        double weight;
    };
    static constexpr std::array<Node, 8> nodes{{{0.170279632305, 0.437723410493},
                                                {0.903701776799, 1.033869347666},
                                                {2.251086629866, 1.669709765659},
                                                {4.266700170288, 2.376924701759},
                                                {7.045905402393, 3.208540913348},
                                                {10.758516010181, 4.268575510825},
                                                {15.740678641278, 5.818083368672},
                                                {22.863131736889, 8.906226215292}}};
    constexpr double length = 25.0;
    const double distance_m = distance_through_air_m(p_m, direction);
    Constituents sum(0.0);
    for (const Node& node : nodes) {
        sum += densities(p_m + direction * (distance_m * node.place / length)) * node.weight;
    }
    return sum * (distance_m / length);
}

[[nodiscard]] double rayleigh_phase(double cosine)
{
    return 3.0 / (16.0 * pi) * (1.0 + cosine * cosine);
}

// Cornette & Shanks 1992.
[[nodiscard]] double dust_phase(double cosine)
{
    constexpr double g = dust_asymmetry;
    return 3.0 * (1.0 - g * g) * (1.0 + cosine * cosine) /
           (8.0 * pi * (2.0 + g * g) * std::pow(1.0 + g * g - 2.0 * g * cosine, 1.5));
}

[[nodiscard]] double transmittance(const Constituents& column_m,
                                   const SkySpectra& spectra,
                                   std::size_t wavelength)
{
    return std::exp(-(column_m.x * spectra.rayleigh_per_m[wavelength] +
                      column_m.y * dust_extinction_per_m +
                      column_m.z * spectra.ozone_per_m[wavelength]));
}

}  // namespace

Air::Air(const Atmosphere& atmosphere, double altitude_m)
    : atmosphere_(atmosphere), observer_m_(0.0, 0.0, earth_radius_m + altitude_m)
{
}

V3d Air::scattered_xyz(const V3d& direction, const V3d& sun) const
{
    constexpr int steps = 32;
    const SkySpectra& spectra = sky_spectra();
    const Constituents amounts(atmosphere_.air, atmosphere_.dust, atmosphere_.ozone);
    const double step_m = distance_through_air_m(observer_m_, direction) / steps;
    const double cosine = direction.dot(sun);
    const double air_phase = rayleigh_phase(cosine);
    const double dust_scattering_sr = dust_phase(cosine) * dust_scattering_per_m;

    SkySpectra::Spectrum radiance{};
    Constituents passed_m(0.0);
    for (int step = 0; step < steps; ++step) {
        const V3d p_m = observer_m_ + direction * ((step + 0.5) * step_m);
        const Constituents here = amounts * densities(p_m);
        passed_m += here * step_m;
        if (meets_earth(p_m, sun)) {
            continue;
        }
        const Constituents way_m = passed_m + amounts * column_m(p_m, sun);
        for (std::size_t i = 0; i < sky_wavelength_count; ++i) {
            const double scattered =
                air_phase * here.x * spectra.rayleigh_per_m[i] + dust_scattering_sr * here.y;
            radiance[i] +=
                spectra.sunlight[i] * transmittance(way_m, spectra, i) * scattered * step_m;
        }
    }
    return xyz_of(radiance);
}

V3d Air::sunlight_xyz(const V3d& direction) const
{
    const Constituents amounts(atmosphere_.air, atmosphere_.dust, 0.0);
    const Constituents way_m = amounts * column_m(observer_m_, direction);
    const SkySpectra& spectra = sky_spectra();
    SkySpectra::Spectrum irradiance{};
    for (std::size_t i = 0; i < sky_wavelength_count; ++i) {
        irradiance[i] = spectra.sunlight[i] * transmittance(way_m, spectra, i);
    }
    return xyz_of(irradiance);
}

}  // namespace eye_render
