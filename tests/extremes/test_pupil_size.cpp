// The pupil's formulas over all light, fields and ages: a size of a pupil, with a report of what
// was clamped, or a refusal.

#include "trial.h"

#include "base/error.h"
#include "base/units.h"
#include "eye/pupil_size.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace eye_render::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double denormal = std::numeric_limits<double>::denorm_min();

std::string text(PupilFormula formula, const PupilConditions& c)
{
    std::ostringstream out;
    out.precision(17);
    out << to_string(formula) << ", " << c.luminance_cd_m2 << " cd/m2, " << c.area_deg2
        << " deg2, " << c.age_years << " years, " << c.eyes << " eyes";
    return out.str();
}

bool reports(const PupilSize& size, std::string_view what)
{
    return std::any_of(size.clamps.begin(), size.clamps.end(),
                       [&](const std::string& clamp) { return clamp.starts_with(what); });
}

// Light of any measure, from none to an atomic flash and beyond, negative included.
double any_luminance(Random& random)
{
    constexpr double special[] = {0.0,   -0.0,     denormal, 1e-300,    1e12,
                                  1e300, infinity, -1.0,     -infinity, NAN};
    if (random.index(4) == 0) return special[random.index(std::size(special))];
    return std::pow(10.0, random.uniform(-12.0, 12.0));
}

PupilConditions any_conditions(Random& random)
{
    return {.luminance_cd_m2 = any_luminance(random),
            .area_deg2 = std::pow(10.0, random.uniform(-6.0, 5.0)),
            .age_years = random.uniform(0.0, 120.0),
            .eyes = random.index(2) == 0 ? 1 : 2};
}

class PupilExtremes : public testing::TestWithParam<PupilFormula> {
protected:
    static double diameter_mm(const PupilConditions& conditions)
    {
        return mm_from_m(pupil_size(GetParam(), conditions).diameter_m);
    }
};

TEST_P(PupilExtremes, any_light_field_and_age_give_a_pupil_and_tell_of_clamps)
{
    Random random(31);
    for (int i = 0; i < 20000; ++i) {
        const PupilConditions c = any_conditions(random);
        const PupilSize size = pupil_size(GetParam(), c);
        ASSERT_GE(size.diameter_m, 1.5e-3) << text(GetParam(), c);
        ASSERT_LE(size.diameter_m, 9e-3) << text(GetParam(), c);
        // Winn's formula goes through data from 9 to 4400 cd/m2.
        const bool is_winn = GetParam() == PupilFormula::Winn;
        ASSERT_EQ(reports(size, "luminance"), !(c.luminance_cd_m2 >= (is_winn ? 9.0 : 1e-6) &&
                                                c.luminance_cd_m2 <= (is_winn ? 4400.0 : 1e6)))
            << text(GetParam(), c);
        const bool ages =
            GetParam() == PupilFormula::WatsonYellott || GetParam() == PupilFormula::Winn;
        ASSERT_EQ(reports(size, "age"), ages && (c.age_years < 20.0 || c.age_years > 83.0))
            << text(GetParam(), c);
        if (size.diameter_m == 1.5e-3 || size.diameter_m == 9e-3) {
            ASSERT_TRUE(reports(size, "pupil")) << text(GetParam(), c);
        }
    }
}

TEST_P(PupilExtremes, more_light_never_widens_the_pupil)
{
    // Blackie & Howland's parabola turns over in the dark, at 10^(-0.658 / 0.14) cd/m2.
    const double darkest = GetParam() == PupilFormula::BlackieHowland ? 2e-5 : 1e-12;
    Random random(32);
    for (int i = 0; i < 5000; ++i) {
        PupilConditions darker = any_conditions(random);
        PupilConditions brighter = darker;
        darker.luminance_cd_m2 = darkest * std::pow(10.0, random.uniform(0.0, 18.0));
        brighter.luminance_cd_m2 =
            darker.luminance_cd_m2 * std::pow(10.0, random.uniform(0.0, 6.0));
        EXPECT_LE(diameter_mm(brighter), diameter_mm(darker) + 1e-12)
            << text(GetParam(), brighter) << "\nagainst " << text(GetParam(), darker);
        brighter = darker;
        brighter.area_deg2 *= 10.0;
        EXPECT_LE(diameter_mm(brighter), diameter_mm(darker) + 1e-12)
            << text(GetParam(), brighter) << "\nagainst " << text(GetParam(), darker);
        darker.eyes = 1;
        brighter = darker;
        brighter.eyes = 2;
        EXPECT_LE(diameter_mm(brighter), diameter_mm(darker) + 1e-12)
            << text(GetParam(), brighter) << "\nagainst " << text(GetParam(), darker);
    }
}

TEST_P(PupilExtremes, small_changes_are_small_changes_of_the_pupil)
{
    // The steepest is Winn's cubic with 2.3 mm per decade of light; at 0.01 degrees across a field
    // nothing is steeper. Age is at most 0.054 mm a year (Watson & Yellott, darkness; Winn 0.043).
    constexpr double mm_per_decade = 2.5;
    constexpr double mm_per_year = 0.06;
    Random random(33);
    for (int i = 0; i < 20000; ++i) {
        const PupilConditions from = any_conditions(random);
        PupilConditions to = from;
        const double step = std::pow(10.0, random.uniform(-9.0, -1.0));
        to.luminance_cd_m2 *= std::pow(10.0, step);
        EXPECT_NEAR(diameter_mm(to), diameter_mm(from), mm_per_decade * step + 1e-12)
            << text(GetParam(), to) << "\nagainst " << text(GetParam(), from);
        to = from;
        to.area_deg2 *= std::pow(10.0, step);
        EXPECT_NEAR(diameter_mm(to), diameter_mm(from), mm_per_decade * step + 1e-12)
            << text(GetParam(), to) << "\nagainst " << text(GetParam(), from);
        to = from;
        to.age_years += step;
        EXPECT_NEAR(diameter_mm(to), diameter_mm(from), mm_per_year * step + 1e-12)
            << text(GetParam(), to) << "\nagainst " << text(GetParam(), from);
    }
}

TEST_P(PupilExtremes, what_is_no_number_is_refused_by_its_name)
{
    const auto refusal = [](const PupilConditions& conditions) -> std::string {
        try {
            return std::to_string(pupil_size(GetParam(), conditions).diameter_m);
        } catch (const std::invalid_argument& error) {
            return error.what();
        }
    };
    for (const double bad : {NAN, -NAN}) {
        EXPECT_NE(refusal({.age_years = bad}).find("age_years is "), std::string::npos);
    }
    for (const double bad : {static_cast<double>(NAN), infinity, -infinity, 0.0, -1.0}) {
        EXPECT_EQ(refusal({.area_deg2 = bad}), "area_deg2 is " + number_text(bad) +
                                                   " deg2; expected more than 0 deg2, and finite");
    }
    for (const int bad : {0, -1, 3, std::numeric_limits<int>::max()}) {
        EXPECT_EQ(refusal({.eyes = bad}), "eyes is " + std::to_string(bad) + "; expected 1 or 2");
    }
}

INSTANTIATE_TEST_SUITE_P(OfEveryFormula,
                         PupilExtremes,
                         testing::ValuesIn(pupil_formulas),
                         [](const auto& formula) {
                             return std::string(to_string(formula.param));
                         });

}  // namespace
}  // namespace eye_render::test
