// The pupil formulas against the vectors, their clamps and their refusals.

#include "eye/pupil_size.h"

#include "../optics_vectors.h"

#include <map>

namespace eye_render {
namespace {

using test::Json;
using enum PupilFormula;

TEST(PupilSize, formulas_give_the_vectors)
{
    const std::map<std::string, PupilFormula> kinds{
        {"pupil_holladay", Holladay},
        {"pupil_crawford", Crawford},
        {"pupil_moon_spencer", MoonSpencer},
        {"pupil_degroot_gebhard", DeGrootGebhard},
        {"pupil_blackie_howland", BlackieHowland},
        {"pupil_stanley_davies", StanleyDavies},
        {"pupil_barten", Barten},
        {"pupil_winn", Winn},
        {"pupil_unified_watson_yellott", WatsonYellott},
    };
    for (const auto& [kind, formula] : kinds) {
        for (const Json& vector : test::vectors_of_kind(kind)) {
            EYE_TRACE_VECTOR(vector);
            const Json& input = vector["input"];
            for (std::size_t i = 0; i < input["L_cd_m2"].size(); ++i) {
                const PupilConditions conditions{.luminance_cd_m2 = input["L_cd_m2"][i],
                                                 .area_deg2 = input.value("area_deg2", 1.0),
                                                 .age_years = input.value("age", 30.0),
                                                 .eyes = input.value("eyes", 2)};
                test::expect_vector_value(published_pupil_diameter_mm(formula, conditions),
                                          vector["expect"]["D_mm"][i]);
            }
        }
    }
}

TEST(PupilSize, the_papers_formula_keeps_its_printed_sign)
{
    // Wang & Xiao eq. 19 with +0.007; Blackie & Howland have -0.07 (7.209 mm and 1.945 mm).
    EXPECT_NEAR(published_pupil_diameter_mm(Paper, {.luminance_cd_m2 = 1e-4}), 8.441, 5e-4);
    EXPECT_NEAR(published_pupil_diameter_mm(Paper, {.luminance_cd_m2 = 1e4}), 3.177, 5e-4);
}

TEST(PupilSize, one_eye_counts_as_a_tenth_of_the_light_in_the_unified_formula)
{
    EXPECT_DOUBLE_EQ(
        published_pupil_diameter_mm(WatsonYellott, {.luminance_cd_m2 = 100.0, .eyes = 1}),
        published_pupil_diameter_mm(WatsonYellott, {.luminance_cd_m2 = 10.0, .eyes = 2}));
}

TEST(PupilSize, every_formula_answers_from_darkness_to_blinding_light)
{
    for (const PupilFormula formula : pupil_formulas) {
        for (const double luminance_cd_m2 : {-1.0, 0.0, 1e-300, 1e-3, 1.0, 1e5, 1e300, HUGE_VAL}) {
            for (const double age_years : {-5.0, 0.0, 150.0, HUGE_VAL}) {
                for (const double area_deg2 : {1e-12, 1.0, 41253.0}) {
                    const PupilSize size = pupil_size(formula, {.luminance_cd_m2 = luminance_cd_m2,
                                                                .area_deg2 = area_deg2,
                                                                .age_years = age_years});
                    EXPECT_GE(size.diameter_m, 1.5e-3) << to_string(formula);
                    EXPECT_LE(size.diameter_m, 9e-3) << to_string(formula);
                }
            }
        }
    }
}

TEST(PupilSize, says_what_it_clamped)
{
    EXPECT_TRUE(pupil_size(WatsonYellott, {.luminance_cd_m2 = 100.0}).clamps.empty());
    const PupilSize dark = pupil_size(WatsonYellott, {.luminance_cd_m2 = 0.0, .age_years = 8.0});
    ASSERT_EQ(dark.clamps.size(), 2u);
    EXPECT_EQ(dark.clamps[0], "luminance 0 cd/m2 taken as 1e-06 cd/m2");
    EXPECT_EQ(dark.clamps[1], "age 8 years taken as 20 years");
    const PupilSize bright = pupil_size(Holladay, {.luminance_cd_m2 = 1e4, .age_years = 8.0});
    ASSERT_EQ(bright.clamps.size(), 1u) << "Holladay knows no age";
    EXPECT_EQ(bright.clamps[0], "pupil 0.127068 mm taken as 1.5 mm");
    EXPECT_DOUBLE_EQ(bright.diameter_m, 1.5e-3);
    const PupilSize unknown = pupil_size(WatsonYellott, {.luminance_cd_m2 = NAN});
    ASSERT_EQ(unknown.clamps.size(), 1u);
    EXPECT_EQ(unknown.clamps[0], "luminance nan cd/m2 taken as 1e-06 cd/m2");
}

TEST(PupilSize, says_where_winns_data_end)
{
    EXPECT_TRUE(pupil_size(Winn, {.luminance_cd_m2 = 9.0}).clamps.empty());
    EXPECT_TRUE(pupil_size(Winn, {.luminance_cd_m2 = 4400.0}).clamps.empty());
    const PupilSize dim = pupil_size(Winn, {.luminance_cd_m2 = 1.0});
    ASSERT_EQ(dim.clamps.size(), 1u);
    EXPECT_EQ(dim.clamps[0], "luminance 1 cd/m2 taken as 9 cd/m2");
    EXPECT_EQ(dim.diameter_m, pupil_size(Winn, {.luminance_cd_m2 = 9.0}).diameter_m);
    const PupilSize bright = pupil_size(Winn, {.luminance_cd_m2 = 1e4});
    ASSERT_EQ(bright.clamps.size(), 1u);
    EXPECT_EQ(bright.clamps[0], "luminance 10000 cd/m2 taken as 4400 cd/m2");
}

TEST(PupilSize, refuses_what_has_no_answer)
{
    EXPECT_THROW(static_cast<void>(pupil_size(Barten, {.area_deg2 = 0.0})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(pupil_size(Barten, {.area_deg2 = NAN})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(pupil_size(Winn, {.eyes = 3})), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(pupil_size(Winn, {.age_years = NAN})), std::invalid_argument);
}

TEST(PupilSize, names_are_all_different)
{
    std::map<std::string_view, int> names;
    for (const PupilFormula formula : pupil_formulas) {
        ++names[to_string(formula)];
    }
    EXPECT_EQ(names.size(), 10u);
    EXPECT_EQ(names.count("DE_GROOT_GEBHARD"), 1u);
}

}  // namespace
}  // namespace eye_render
