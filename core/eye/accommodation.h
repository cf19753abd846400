// How far an eye can change its power, and what it does with that.
//
// Vergences (1/distance, in dioptres, from the plane that the prescription is referred to) are
// used rather than distances: they have no infinity.

#pragma once

#include "optics/power_matrix.h"

#include <array>
#include <string_view>

namespace eye_render {

enum class AmplitudeFormula {
    HofstetterMinimum,  // 1950: 15 - 0.25 age, subjective push-up
    HofstetterMean,     // 18.5 - 0.30 age
    HofstetterMaximum,  // 25 - 0.40 age
    Anderson,           // 2008: objective, 7.33 - 0.0035 (age - 3)^2, measured from 3 to 40 years
};

inline constexpr std::array amplitude_formulas{
    AmplitudeFormula::HofstetterMean, AmplitudeFormula::HofstetterMinimum,
    AmplitudeFormula::HofstetterMaximum, AmplitudeFormula::Anderson};

// "HOFSTETTER_MEAN", "HOFSTETTER_MINIMUM", "HOFSTETTER_MAXIMUM", "ANDERSON".
[[nodiscard]] std::string_view to_string(AmplitudeFormula formula);

// Never negative: 0 once the formula has run out, near 60 (Anderson: 48.8) years. Ages below 3
// count as 3. Throws std::invalid_argument unless the age is 0 to 120.
[[nodiscard]] double accommodation_amplitude_d(
    double age_years,
    AmplitudeFormula formula = AmplitudeFormula::HofstetterMean);

// The accommodation, 0 to `amplitude_d`, by which an eye without higher aberrations blurs an
// object least that it sees with the error `relaxed_error_d` when relaxed: it puts the circle of
// least confusion on the retina, as far as the amplitude allows.
[[nodiscard]] double best_accommodation_d(const PowerMatrix& relaxed_error_d, double amplitude_d);

// Distance of a vergence: infinite for 0, negative behind the eye.
[[nodiscard]] double distance_m(double vergence_d);

}  // namespace eye_render
