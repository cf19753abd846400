// One eye for the outside, in the user's units: what Python's Eye and the add-on's panels ask.

#pragma once

#include "analysis/blur_ellipse.h"
#include "eye/accommodation.h"
#include "eye/eye_factory.h"
#include "eye/pupil_pattern.h"
#include "eye/pupil_size.h"
#include "optics/prescription.h"
#include "optics/prescription_text.h"

#include <memory>

namespace eye_render {

struct EyeDescription {
    EyeModelKind model = EyeModelKind::Paraxial;
    Prescription rx{};
    RxPlane rx_plane = RxPlane::Spectacle;
    double vertex_mm = 12.0;
    double pupil_mm = 4.0;
    double accommodation_d = 0.0;
};

// Throws std::invalid_argument with name, value, unit and range.
[[nodiscard]] std::unique_ptr<EyeModel> make_eye(const EyeDescription& description);

// The blur of a point at `object_distance_m` from the entrance pupil, above 0 up to infinity;
// throws std::invalid_argument for other distances.
[[nodiscard]] BlurEllipse blur_at(const EyeModel& eye, double object_distance_m);

// Diameter of the entrance pupil, clamped as `pupil_size` says.
[[nodiscard]] double pupil_diameter_mm(PupilFormula formula, const PupilConditions& conditions);

}  // namespace eye_render
