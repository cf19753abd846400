// The colours of spectra as the CIE 1931 2 degree standard observer sees them (CIE 15:2004, table
// T.4, every 5 nm, to four places as CIE 1931 published it).

#pragma once

#include "base/vector.h"

namespace eye_render {

inline constexpr float observer_first_nm = 380.0f;
inline constexpr float observer_step_nm = 5.0f;
inline constexpr int observer_count = 81;  // to 780 nm

// X, Y and Z of light of one wavelength, per unit of power; Y is 1 at 555 nm. Linear between the
// table's rows, and on for one step before the first as Blender has it; 0 outside.
[[nodiscard]] V3f xyz_of_wavelength(float wavelength_nm);

}  // namespace eye_render
