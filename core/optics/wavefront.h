// The wavefront aberrations of an eye, as an aberrometer reports them: coefficients of Zernike
// polynomials over a measured pupil.
//
// OSA/ANSI standard (Thibos et al. 2002): W is the height, in micrometres, of the wavefront that
// leaves the eye above the pupil, positive where it is ahead, as at the centre of a myope's. The
// frame is the clinician's, who faces the patient: x to his right, y up, the same for both eyes.
// Seen by the patient x is mirrored; `mirrored` goes either way. The slope in object space of the
// ray through a pupil point is minus the gradient of W.

#pragma once

#include "optics/chromatic.h"
#include "optics/prescription.h"
#include "optics/zernike.h"

#include <vector>

namespace eye_render {

inline constexpr std::size_t max_zernike_terms = 28;  // to the 6th order
inline constexpr double max_zernike_um = 1000.0;      // far beyond any eye
inline constexpr double min_wavefront_pupil_m = 1e-3;
inline constexpr double max_wavefront_pupil_m = 10e-3;

struct Wavefront {
    std::vector<double> coefficients_um{};  // by OSA index from 0; what is missing is 0
    double pupil_diameter_m = 6e-3;         // of the pupil that the coefficients belong to
    double wavelength_nm = reference_wavelength_nm;  // of the measurement
};

// Throws std::invalid_argument for more than 28 coefficients and for numbers out of range.
void require_valid(const Wavefront& wavefront);

// Throws std::invalid_argument when the pupil is wider than the wavefront, beyond which nothing
// was measured. The message names both.
void require_covers(const Wavefront& wavefront, double pupil_diameter_m);

// Seen from the other side, from the clinician's frame to the camera's and back: negates what is
// odd in x. The fellow eye of a mirror-symmetric pair, too.
[[nodiscard]] Wavefront mirrored(const Wavefront& wavefront);

// The part of the same wavefront inside a smaller, concentric pupil (Janssen & Dirksen 2006,
// "Concise formula for the Zernike coefficients of scaled pupils"). Throws std::invalid_argument
// for a larger pupil.
[[nodiscard]] Wavefront rescaled(const Wavefront& wavefront, double pupil_diameter_m);

// Root mean square over the pupil of what no prescription corrects: the third order and above.
[[nodiscard]] double higher_order_rms_um(const Wavefront& wavefront);

// W in micrometres over points in pupil radii.
[[nodiscard]] PupilPolynomial polynomial_um(const Wavefront& wavefront);

// The wavefront, in the second order alone, that a lens of this power (TABO) corrects.
[[nodiscard]] Wavefront wavefront_corrected_by(const PowerVector& rx, double pupil_diameter_m);

// The lens (TABO, at the plane of the pupil) that flattens the wavefront at the pupil's centre,
// converted from the wavelength of the measurement to 555 nm: Thibos, Hong, Bradley & Applegate
// 2004 ("Accuracy and precision of objective refraction from wavefront aberrations", J. Vision
// 4(4)) found it nearest, on the mean of 200 eyes, to what an optometrist prescribes. Higher
// orders take part, as far as they are curved there.
[[nodiscard]] PowerVector paraxial_refraction(const Wavefront& wavefront);

}  // namespace eye_render
