// Colours of light by its physics: of one wavelength, and of a body that glows at a temperature.
// Cut off at the edge of the working space's gamut.

#pragma once

#include "base/working_space.h"

namespace eye_render {

// Scaled so that no channel of Rec. 709 exceeds 1 anywhere in the spectrum; black outside 375 to
// 780 nm.
[[nodiscard]] Color3f rgb_of_wavelength(float wavelength_nm, WorkingSpace space);

// Planck's law seen by the CIE 1931 observer, of luminance 1 before it is cut off. Temperatures
// count as 800 K at least and 12,000 K at most; one that is not a number is black.
[[nodiscard]] Color3f rgb_of_blackbody(float temperature_k, WorkingSpace space);

}  // namespace eye_render
