// Eyes with real surfaces: Navarro's, the Arizona eye and Le Grand's, made for a person.
//
// A pixel with chief slope u is the point of the curved retina where the chief ray from that
// direction lands: the one through the centre of the stop, at 555 nm. Its other rays run from this
// point through the stop and the cornea into the scene, refracted exactly at their own wavelength,
// so that spherical and chromatic aberration, oblique astigmatism, coma and field curvature are
// what the surfaces make them. The retina's own mapping (distortion) is not in the picture, which
// is in object space.

#pragma once

#include "eye/eye_model.h"
#include "optics/schematic_eyes.h"

#include <array>
#include <memory>
#include <string_view>

namespace eye_render {

// What a refraction of zero means for an eye with spherical aberration, at 555 nm on the axis.
enum class RefractionZero {
    Paraxial,        // rays next to the axis come to a focus on the retina
    MinimumRmsSpot,  // the RMS of the point's blur through the whole pupil is least
};

inline constexpr std::array refraction_zeros{RefractionZero::Paraxial,
                                             RefractionZero::MinimumRmsSpot};

// "paraxial", "minimum_rms_spot".
[[nodiscard]] std::string_view to_string(RefractionZero zero);

inline constexpr double max_fit_error_arcmin = 0.02;

struct SchematicSpec {
    SchematicEyeKind kind = SchematicEyeKind::Navarro;
    PowerMatrix rx_entrance_pupil_d{};  // camera frame
    double accommodation_d = 0.0;       // true accommodation, referred to the entrance pupil
    double pupil_diameter_m = 4e-3;     // of the entrance pupil
    RefractionZero zero = RefractionZero::Paraxial;
    bool exact_trace = false;
};

// The mean sphere is made by the length of the vitreous body, the cylinder by a biconic anterior
// cornea (each of its radii solved for its meridian), accommodation by the publication's own
// parameter with the axial length kept; all to first order but for RefractionZero::MinimumRmsSpot,
// which counts in the mean sphere, in retinal_conjugate_d(), too. Accommodation takes the entrance
// pupil towards the cornea, so the cylinder seen from there becomes a few per cent smaller. The
// pupil is a round entrance pupil as seen from far away on the axis, and the stop is what makes it
// so by real rays at 555 nm.
//
// Unless `exact_trace`, rays up to 40 degrees from the axis are fitted, or in a narrower field as
// far as that does them right: over this field, the pupil and the visible wavelengths
// approximation_arcmin(), which is found by comparison when the eye is made, is at most
// `max_fit_error_arcmin`. Without any such field, which fitted_field_deg() tells, every ray is
// traced exactly.
//
// Throws std::invalid_argument when no such eye exists.
[[nodiscard]] std::unique_ptr<EyeModel> make_schematic_eye(const SchematicSpec& spec);

}  // namespace eye_render
