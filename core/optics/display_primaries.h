// Which wavelengths red, green and blue stand for, and wavelengths to trace in proportion.
//
// A picture's three channels have no spectrum of their own. Each is given the one that the CIE
// 1931 observer (Wyman, Sloan & Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color
// Matching Functions", JCGT 2(2), multi-lobe fit) matches with that primary of the working space,
// without its negative parts and scaled to 1 in all from 400 to 700 nm. White then has as much
// light in each channel as before: the mean of weight over density is 1.

#pragma once

#include "base/working_space.h"

namespace eye_render {

inline constexpr double min_display_nm = 400.0;
inline constexpr double max_display_nm = 700.0;

// How much of the light of each channel lies at a wavelength, per nanometre: none negative, 0
// outside 400 to 700 nm.
[[nodiscard]] V3d display_primaries(double wavelength_nm, WorkingSpace space);

// A wavelength of 400 to 700 nm from u in [0, 1).
[[nodiscard]] double sample_wavelength_nm(double u, WorkingSpace space);

// Its density, the mean of the three primaries, per nanometre: above 0 wherever a primary is, so a
// channel's weight over density is never more than 3.
[[nodiscard]] double wavelength_pdf(double wavelength_nm, WorkingSpace space);

// The u that gives a wavelength: the cumulative density.
[[nodiscard]] double invert_wavelength(double wavelength_nm, WorkingSpace space);

}  // namespace eye_render
