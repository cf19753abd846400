// The spot on the retina of a distant point on the axis, forwards through the eye's surfaces, and
// its modulation transfer function: what lens-design programs print, and so the independent check
// of a schematic eye. Everything else in analysis looks out of the eye, in object space.

#pragma once

#include "optics/lens_system.h"

#include <span>
#include <vector>

namespace eye_render {

// Where light that fills the cornea evenly and passes a round stop of this diameter lands, in
// metres from the axis.
[[nodiscard]] std::vector<V2d> retinal_spot_m(const LensSystem& system,
                                              double stop_diameter_m,
                                              double wavelength_nm);

// The modulus of the spot's Fourier transform along x, for each frequency in cycles per metre; 1
// at frequency 0. All 0 for a spot without points. Rays know no diffraction.
[[nodiscard]] std::vector<double> retinal_mtf(std::span<const V2d> spot_m,
                                              std::span<const double> frequencies_per_m);

}  // namespace eye_render
