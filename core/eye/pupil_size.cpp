// The published pupil formulas; see pupil_size.h for units.

#include "eye/pupil_size.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

constexpr double min_age_years = 20.0;
constexpr double max_age_years = 83.0;
constexpr double min_diameter_mm = 1.5;
constexpr double max_diameter_mm = 9.0;

struct Limits {
    double minimum;
    double maximum;
};

// Of the data of Winn et al.: their cubic leads anywhere beyond.
constexpr Limits winn_luminance_cd_m2{9.0, 4400.0};
constexpr Limits other_luminance_cd_m2{1e-6, 1e6};

// Of the corneal flux density L a, cd/m^2 deg^2.
double stanley_davies_mm(double flux)
{
    const double g = std::pow(flux / 846.0, 0.41);
    return 7.75 - 5.75 * (g / (g + 2.0));
}

double watson_yellott_mm(const PupilConditions& c)
{
    constexpr double reference_age_years = 28.58;
    const double one_eye_attenuation = c.eyes == 1 ? 0.1 : 1.0;
    const double young_mm =
        stanley_davies_mm(c.luminance_cd_m2 * c.area_deg2 * one_eye_attenuation);
    return young_mm + (c.age_years - reference_age_years) * (0.02132 - 0.009562 * young_mm);
}

// Watson & Yellott's polynomial through the data of Winn et al.
double winn_mm(const PupilConditions& c)
{
    constexpr std::array slope{-0.024501, -0.0368073, 0.0210892, -0.00281557};
    constexpr std::array intercept{6.9039, 2.7765, -1.909, 0.25599};
    const double log_l = std::log10(
        std::clamp(c.luminance_cd_m2, winn_luminance_cd_m2.minimum, winn_luminance_cd_m2.maximum));
    double diameter_mm = 0.0;
    for (std::size_t k = slope.size(); k-- > 0;) {
        diameter_mm = diameter_mm * log_l + intercept[k] + c.age_years * slope[k];
    }
    return diameter_mm;
}

bool uses_age(PupilFormula formula)
{
    return formula == PupilFormula::WatsonYellott || formula == PupilFormula::Winn;
}

// Clamps, and says so when that changes the value. NaN is taken as the least.
double clamped(double value,
               double minimum,
               double maximum,
               std::string_view name,
               std::string_view unit,
               std::vector<std::string>& clamps)
{
    const double result = std::isnan(value) ? minimum : std::clamp(value, minimum, maximum);
    if (result != value) {
        clamps.push_back(std::string(name) + " " + number_text(value) + " " + std::string(unit) +
                         " taken as " + number_text(result) + " " + std::string(unit));
    }
    return result;
}

}  // namespace

std::string_view to_string(PupilFormula formula)
{
    switch (formula) {
    case PupilFormula::WatsonYellott: return "WATSON_YELLOTT";
    case PupilFormula::BlackieHowland: return "BLACKIE_HOWLAND";
    case PupilFormula::Paper: return "PAPER";
    case PupilFormula::Holladay: return "HOLLADAY";
    case PupilFormula::Crawford: return "CRAWFORD";
    case PupilFormula::MoonSpencer: return "MOON_SPENCER";
    case PupilFormula::DeGrootGebhard: return "DE_GROOT_GEBHARD";
    case PupilFormula::StanleyDavies: return "STANLEY_DAVIES";
    case PupilFormula::Barten: return "BARTEN";
    case PupilFormula::Winn: return "WINN";
    }
    return "";
}

double published_pupil_diameter_mm(PupilFormula formula, const PupilConditions& c)
{
    const double log_l = std::log10(c.luminance_cd_m2);
    switch (formula) {
    case PupilFormula::WatsonYellott: return watson_yellott_mm(c);
    case PupilFormula::BlackieHowland: return 5.697 - 0.658 * log_l - 0.07 * log_l * log_l;
    case PupilFormula::Paper: return 5.697 - 0.658 * log_l + 0.007 * log_l * log_l;
    case PupilFormula::Holladay: return 7.0 * std::exp(-0.1007 * std::pow(c.luminance_cd_m2, 0.4));
    case PupilFormula::Crawford: return 5.0 - 2.2 * std::tanh(0.61151 + 0.447 * log_l);
    case PupilFormula::MoonSpencer: return 4.9 - 3.0 * std::tanh(0.4 * log_l - 0.00114);
    case PupilFormula::DeGrootGebhard:
        return 7.175 * std::exp(-0.00092 * std::pow(7.597 + log_l, 3));
    case PupilFormula::StanleyDavies: return stanley_davies_mm(c.luminance_cd_m2 * c.area_deg2);
    case PupilFormula::Barten:
        return 5.0 - 3.0 * std::tanh(0.4 * (log_l + std::log10(c.area_deg2 / (40.0 * 40.0))));
    case PupilFormula::Winn: return winn_mm(c);
    }
    return 0.0;
}

PupilSize pupil_size(PupilFormula formula, const PupilConditions& conditions)
{
    if (!(conditions.area_deg2 > 0.0) || std::isinf(conditions.area_deg2)) {
        throw std::invalid_argument("area_deg2 is " + number_text(conditions.area_deg2) +
                                    " deg2; expected more than 0 deg2, and finite");
    }
    if (conditions.eyes != 1 && conditions.eyes != 2) {
        throw std::invalid_argument("eyes is " + std::to_string(conditions.eyes) +
                                    "; expected 1 or 2");
    }
    if (std::isnan(conditions.age_years)) {
        throw std::invalid_argument("age_years is nan; expected a number");
    }
    const Limits& luminance =
        formula == PupilFormula::Winn ? winn_luminance_cd_m2 : other_luminance_cd_m2;
    PupilSize result;
    PupilConditions usable = conditions;
    usable.luminance_cd_m2 = clamped(conditions.luminance_cd_m2, luminance.minimum,
                                     luminance.maximum, "luminance", "cd/m2", result.clamps);
    if (uses_age(formula)) {
        usable.age_years = clamped(conditions.age_years, min_age_years, max_age_years, "age",
                                   "years", result.clamps);
    }
    result.diameter_m =
        m_from_mm(clamped(published_pupil_diameter_mm(formula, usable), min_diameter_mm,
                          max_diameter_mm, "pupil", "mm", result.clamps));
    return result;
}

}  // namespace eye_render
