// The modulation transfer function: the contrast at which an eye shows a sinusoidal grating, by
// rays alone and with diffraction. Both are sums over the rays themselves, so that no pixel grid
// softens them.
//
// Geometrical: the modulus of the Fourier transform of the spot.
//
// With diffraction: the autocorrelation of the pupil, whose copies lie wavelength x frequency
// apart (Hopkins 1955, "The frequency response of a defocused optical system"). The difference of
// the wavefront between two points is their distance times its slope half-way, which is the ray's
// angle: exact for defocus and astigmatism, and for higher aberrations up to the cube of the
// distance. So it is the geometrical sum over those rays that lie in both copies, and it never
// exceeds `diffraction_mtf`.

#pragma once

#include "analysis/spot.h"
#include "optics/chromatic.h"

#include <span>

namespace eye_render {

// For each frequency in cycles per degree. `meridian_deg` is the direction across the grating's
// bars, counter-clockwise from +X as the patient sees: 0 for vertical bars. All 0 when nothing is
// transmitted.
[[nodiscard]] std::vector<double> geometric_mtf(const Spot& spot,
                                                double meridian_deg,
                                                std::span<const double> frequencies_cpd);

struct RoundPupil {
    double diameter_m = 0.0;
    double wavelength_nm = reference_wavelength_nm;
};

[[nodiscard]] std::vector<double> wave_mtf(const Spot& spot,
                                           const RoundPupil& pupil,
                                           double meridian_deg,
                                           std::span<const double> frequencies_cpd);

}  // namespace eye_render
