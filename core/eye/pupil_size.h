// The diameter of the entrance pupil from the light and the person, by the published formulas.
//
// All are photopic, steady-state fits of the *entrance* pupil (13 % wider than the iris opening):
// luminance in cd/m^2, logarithms to base 10, field area in square degrees. Constants as reviewed
// by Watson & Yellott 2012, "A unified formula for light-adapted pupil size" (J. Vision
// 12(10)):12, whose unified formula is the default.

#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace eye_render {

enum class PupilFormula {
    WatsonYellott,   // luminance, field, age, one or two eyes
    BlackieHowland,  // 1999, luminance only, as are the next five
    Paper,        // Wang & Xiao 2013 eq. 19: Blackie & Howland with the sign and size misprinted
    Holladay,     // 1926
    Crawford,     // 1936
    MoonSpencer,  // 1944
    DeGrootGebhard,  // 1952
    StanleyDavies,   // 1995, luminance and field
    Barten,          // 1999, luminance and field
    Winn,            // 1994, luminance and age
};

inline constexpr std::array pupil_formulas{
    PupilFormula::WatsonYellott,  PupilFormula::BlackieHowland,
    PupilFormula::Paper,          PupilFormula::Holladay,
    PupilFormula::Crawford,       PupilFormula::MoonSpencer,
    PupilFormula::DeGrootGebhard, PupilFormula::StanleyDavies,
    PupilFormula::Barten,         PupilFormula::Winn};

// "WATSON_YELLOTT", "BLACKIE_HOWLAND", ...
[[nodiscard]] std::string_view to_string(PupilFormula formula);

struct PupilConditions {
    double luminance_cd_m2 = 100.0;
    double area_deg2 = 3600.0;  // of the adapting field
    double age_years = 30.0;
    int eyes = 2;  // how many see the field, 1 or 2
};

// The formula as published, millimetres, wherever that leads: Holladay's tends to 0 in bright
// light, Blackie & Howland's turns over, Winn's stays what it is at the
// ends of its data. Luminance above 0.
[[nodiscard]] double published_pupil_diameter_mm(PupilFormula formula,
                                                 const PupilConditions& conditions);

struct PupilSize {
    double diameter_m = 0.0;
    // What was clamped, one sentence each: luminance to 1e-6..1e6 cd/m^2 or, for Winn, to the
    // 9..4400 cd/m^2 of the data (NaN counts as the least), age (where the formula
    // uses it) to 20..83 years, diameter to 1.5..9 mm.
    std::vector<std::string> clamps;
};

// Throws std::invalid_argument for an age of NaN, an area that is not above 0 and finite, or eyes
// other than 1 and 2. Everything else has an answer.
[[nodiscard]] PupilSize pupil_size(PupilFormula formula, const PupilConditions& conditions);

}  // namespace eye_render
