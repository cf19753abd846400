// The mean aberrations of healthy eyes.
//
// The 200 eyes of the Indiana study: Thibos, Hong, Bradley & Cheng 2002, "Statistical variation of
// aberration structure and image quality in a normal population of healthy eyes" (J. Opt. Soc. Am.
// A 19), well corrected, at 633 nm, third and fourth order. Single eyes scatter around these means
// by more than the means themselves: the mean eye has spherical aberration and hardly any coma,
// and its higher-order RMS, 0.10 um over 6 mm, is less than half of what an eye has on average
// (0.28 um).

#pragma once

#include "optics/wavefront.h"

namespace eye_render {

inline constexpr double max_population_pupil_m = 7.5e-3;

// Over a pupil of 1 to 7.5 mm: between the measured pupils of 3, 4.5, 6 and 7.5 mm each
// coefficient goes linearly, so that nothing jumps when the pupil moves; below 3 mm it is the
// inner part of the smallest. The left eye is the right one's mirror image; any other side counts
// as right. Throws std::invalid_argument for other pupils.
[[nodiscard]] Wavefront population_wavefront(double pupil_diameter_m,
                                             EyeSide eye = EyeSide::Right);

}  // namespace eye_render
