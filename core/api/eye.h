// One eye for the outside, in the user's units: what Python's Eye and the add-on's panels ask,
// with the units and the text of numbers that go with it.

#pragma once

#include "analysis/blur_ellipse.h"
#include "base/error.h"
#include "base/units.h"
#include "eye/accommodation.h"
#include "eye/eye_factory.h"
#include "eye/pupil_pattern.h"
#include "eye/pupil_size.h"
#include "optics/population_wavefront.h"
#include "optics/prescription.h"
#include "optics/prescription_text.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace eye_render {

// Nearer objects would touch the eye.
inline constexpr double min_object_distance_m = 0.01;

enum class Correction { None, Glasses, Contacts };

inline constexpr std::array corrections{Correction::None, Correction::Glasses,
                                        Correction::Contacts};

// "none", "glasses", "contacts".
[[nodiscard]] std::string_view to_string(Correction correction);

struct EyeDescription {
    EyeModelKind model = EyeModelKind::Paraxial;
    Prescription rx{};  // the eye's own
    RxPlane rx_plane = RxPlane::Spectacle;
    double vertex_mm = 12.0;  // of the refraction, and of glasses
    double pupil_mm = 4.0;
    double accommodation_d = 0.0;
    Correction correction = Correction::None;
    // What the lenses are made to: as written for glasses or, for contacts, for the cornea.
    // Nothing: the eye's own prescription, referred to the lens's plane.
    std::optional<Prescription> worn{};
    bool near_part = false;  // glasses: looks through the part with the reading addition
    RefractionZero refraction_zero = RefractionZero::Paraxial;  // schematic eyes: what 0 D means
    bool exact_trace = false;  // schematic eyes: every ray through the surfaces, not by the fit
    // What EyeModelKind::Wavefront needs, clinician's frame; its tilt and second order are left to
    // `rx`.
    std::optional<Wavefront> wavefront{};
};

// Throws std::invalid_argument with name, value, unit and range.
[[nodiscard]] std::unique_ptr<EyeModel> make_eye(const EyeDescription& description);

// Of an object `min_object_distance_m` from the entrance pupil or farther, up to infinity; throws
// std::invalid_argument for other distances.
[[nodiscard]] double object_vergence_d(double distance_m);

// The paraxial blur of a point at that distance.
[[nodiscard]] BlurEllipse blur_at(const EyeModel& eye, double distance_m);

// Paraxial root mean square width of a line's spread across itself; `line_deg` is the line's own
// direction, counter-clockwise from +X as the patient sees.
[[nodiscard]] double line_spread_arcmin(const EyeModel& eye, double line_deg, double distance_m);

// Where a point's blur through the whole pupil is least, for a toric eye in the mean, at 555 nm:
// infinite for an emmetrope, negative behind a hyperope's eye. As in clear_ranges(); without
// aberrations it is the paraxial far point, and so it is for a closed pupil.
[[nodiscard]] double far_point_m(const EyeModel& eye);

// As Python writes it: "Wavefront([0, 0, 0, 0.1], pupil_mm=6, wavelength_nm=555)".
[[nodiscard]] std::string wavefront_text(const Wavefront& wavefront);

// Diameter of the entrance pupil, clamped as `pupil_size` says. Throws std::invalid_argument as it
// does, and for a luminance that is negative or NaN: no report tells of those clamps here.
[[nodiscard]] double pupil_diameter_mm(PupilFormula formula, const PupilConditions& conditions);

}  // namespace eye_render
