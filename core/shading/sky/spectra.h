// What the sky is made of, at 21 wavelengths from 380 to 780 nm.

#pragma once

#include "base/vector.h"

#include <array>

namespace eye_render {

inline constexpr int sky_wavelength_count = 21;
inline constexpr double sky_wavelength_step_nm = 20.0;

struct SkySpectra {
    using Spectrum = std::array<double, sky_wavelength_count>;

    Spectrum sunlight;                               // irradiance above the air, W/(m^2 nm)
    Spectrum rayleigh_per_m;                         // scattering of air at sea level
    Spectrum ozone_per_m;                            // absorption of ozone where it is densest
    std::array<V3d, sky_wavelength_count> observer;  // CIE 1931
};

[[nodiscard]] const SkySpectra& sky_spectra();

[[nodiscard]] V3d xyz_of(const SkySpectra::Spectrum& spectrum);

}  // namespace eye_render
