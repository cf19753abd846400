// Amplitude by age and the best use of it.

#include "eye/accommodation.h"

#include "base/error.h"

#include <limits>

namespace eye_render {

namespace {

double unclamped_amplitude_d(double age_years, AmplitudeFormula formula)
{
    switch (formula) {
    case AmplitudeFormula::HofstetterMinimum: return 15.0 - 0.25 * age_years;
    case AmplitudeFormula::HofstetterMean: return 18.5 - 0.30 * age_years;
    case AmplitudeFormula::HofstetterMaximum: return 25.0 - 0.40 * age_years;
    case AmplitudeFormula::Anderson: return 7.33 - 0.0035 * (age_years - 3.0) * (age_years - 3.0);
    }
    return 0.0;
}

}  // namespace

std::string_view to_string(AmplitudeFormula formula)
{
    switch (formula) {
    case AmplitudeFormula::HofstetterMinimum: return "HOFSTETTER_MINIMUM";
    case AmplitudeFormula::HofstetterMean: return "HOFSTETTER_MEAN";
    case AmplitudeFormula::HofstetterMaximum: return "HOFSTETTER_MAXIMUM";
    case AmplitudeFormula::Anderson: return "ANDERSON";
    }
    return "";
}

double accommodation_amplitude_d(double age_years, AmplitudeFormula formula)
{
    require_range("age_years", age_years, 0.0, 120.0, "years");
    return std::max(0.0, unclamped_amplitude_d(std::max(3.0, age_years), formula));
}

double best_accommodation_d(const PowerMatrix& relaxed_error_d, double amplitude_d)
{
    // 0 - 0 is no -0.
    return std::clamp(0.0 - relaxed_error_d.mean_d(), 0.0, amplitude_d);
}

double distance_m(double vergence_d)
{
    // Not 1/-0, which would put an emmetrope's far point behind the eye.
    return vergence_d == 0.0 ? std::numeric_limits<double>::infinity() : 1.0 / vergence_d;
}

}  // namespace eye_render
