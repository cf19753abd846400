// The eye's longitudinal chromatic aberration: how its refraction changes with wavelength.
//
// Thibos, Ye, Zhang & Bradley 1992, "The chromatic eye" (Appl. Opt. 31): a reduced eye of water
// with Rx(lambda) = 1.68524 - 633.46 / (lambda - 214.102) dioptres, lambda in nanometres.

#pragma once

#include <algorithm>

namespace eye_render {

inline constexpr double min_wavelength_nm = 380.0;
inline constexpr double max_wavelength_nm = 780.0;
// Aberrometers measure in the near infrared, to which the formula is continued.
inline constexpr double max_infrared_nm = 1100.0;

// Where a prescription is right: the peak of photopic vision.
inline constexpr double reference_wavelength_nm = 555.0;

// Rx(lambda) - Rx(reference), by which the correcting lens would have to change: negative in the
// blue, where the eye is too strong, and exactly 0 at the reference. Wavelengths outside 380 to
// 1100 nm count as the nearest end.
[[nodiscard]] constexpr double chromatic_difference_d(
    double wavelength_nm,
    double reference_nm = reference_wavelength_nm)
{
    const auto rx_d = [](double nm) {
        return 1.68524 - 633.46 / (std::clamp(nm, min_wavelength_nm, max_infrared_nm) - 214.102);
    };
    return rx_d(wavelength_nm) - rx_d(reference_nm);
}

}  // namespace eye_render
