// What diffraction at a round pupil allows at most, and where it outweighs geometrical blur.
//
// Born & Wolf, Principles of Optics, 8.5.2 and 9.5.2: the Airy pattern's first dark ring at
// 1.2197 lambda/p, and the transfer of an even round pupil up to the cutoff p/lambda. All pupils
// have a diameter above 0.

#pragma once

#include "analysis/spot.h"

namespace eye_render {

[[nodiscard]] double airy_radius_rad(double pupil_diameter_m, double wavelength_nm);

// The defocus whose blur disk is as wide as the Airy disk.
[[nodiscard]] double airy_defocus_d(double pupil_diameter_m, double wavelength_nm);

// Rayleigh's limit: a wavefront error of a quarter of a wave at the pupil's edge.
[[nodiscard]] double quarter_wave_defocus_d(double pupil_diameter_m, double wavelength_nm);

[[nodiscard]] double diffraction_cutoff_cpd(double pupil_diameter_m, double wavelength_nm);

// The modulation transfer of an eye without errors, which no eye of that pupil exceeds. 1 at
// frequency 0, 0 from the cutoff on; even in frequency.
[[nodiscard]] double diffraction_mtf(double frequency_cpd,
                                     double pupil_diameter_m,
                                     double wavelength_nm);

// Whether the blur, at its longest, is shorter than the Airy disk: then a picture made by rays is
// sharper than an eye can see.
[[nodiscard]] bool diffraction_dominates(const SpotMoments& moments,
                                         double pupil_diameter_m,
                                         double wavelength_nm);

}  // namespace eye_render
