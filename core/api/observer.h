// The observer as the outside says them: plain values in the user's units, which observer_eye.h
// turns into an eye.

#pragma once

#include "api/eye.h"

#include <optional>
#include <string_view>

namespace eye_render {

enum class FocusMode { Relaxed, Distance, Center };

// "relaxed", "distance", "center".
[[nodiscard]] std::string_view to_string(FocusMode mode);

struct Observer {
    // Its pupil and accommodation are found, and not read. The wavefront model without a wavefront
    // is the mean of healthy eyes.
    EyeDescription eye{};
    double age_years = 30.0;
    AmplitudeFormula amplitude_formula = AmplitudeFormula::HofstetterMean;
    std::optional<double> pupil_mm;  // nothing: from the light of the scene
    PupilFormula pupil_formula = PupilFormula::WatsonYellott;
    double cd_m2_per_unit = 179.0;  // luminance of radiance 1 in all channels
    double luminance_sigma = 0.5;   // of the Gaussian weight, in half picture heights and widths
    std::optional<double> field_area_deg2;  // that the pupil adapts to; nothing: the picture's
    int eyes = 2;                           // that see the light, 1 or 2
    FocusMode focus = FocusMode::Relaxed;
    double focus_distance_m = 0.0;  // with FocusMode::Distance, from the entrance pupil
};

}  // namespace eye_render
