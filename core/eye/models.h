// The makers of the concrete models, each in its own file; eye_factory.h is the way in. Arguments
// are checked there.

#pragma once

#include "eye/eye_model.h"
#include "eye/worn_lens.h"
#include "optics/wavefront.h"

#include <memory>

namespace eye_render {

[[nodiscard]] std::unique_ptr<EyeModel> make_pinhole_eye();

// `rx_camera` is taken at the lens, whatever plane it was written for. Throws
// std::invalid_argument when it needs a lens without power or weaker.
[[nodiscard]] std::unique_ptr<EyeModel> make_paper_eye(const PowerMatrix& rx_camera,
                                                       double accommodation_d,
                                                       double pupil_diameter_m,
                                                       double eye_length_m);

[[nodiscard]] std::unique_ptr<EyeModel> make_paraxial_eye(const PowerMatrix& retinal_conjugate_d,
                                                          double pupil_diameter_m);

// The paraxial eye plus what lies beyond the second order in `wavefront`, which covers the pupil
// and is in the clinician's frame.
[[nodiscard]] std::unique_ptr<EyeModel> make_wavefront_eye(const PowerMatrix& retinal_conjugate_d,
                                                           double pupil_diameter_m,
                                                           const Wavefront& wavefront);

// The eye behind a lens. Throws std::invalid_argument for a lens with numbers out of range.
[[nodiscard]] std::unique_ptr<EyeModel> make_corrected_eye(std::unique_ptr<const EyeModel> eye,
                                                           const WornLens& lens);

}  // namespace eye_render
