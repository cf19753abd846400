// Photometric files: what a published example says, how types and symmetries are laid out, and
// what is refused.

#include "shading/ies_profile.h"

#include "asked_node.h"
#include "base/units.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace eye_render {
namespace {

constexpr float watts_per_cd = static_cast<float>(watts_per_candela);

// The example in Autodesk's manuals (3ds Max, AutoCAD) of the format of 1991.
const std::string downlight = "IESNA91\n[TEST] Simple demo intensity distribution\n"
                              "[MANUFAC] Lightscape Technologies, Inc.\nTILT=NONE\n"
                              "1\n-1\n1\n8\n1\n1\n2\n0.0 0.0 0.0\n1.0 1.0 0.0\n"
                              "0.0 5.0 10.0 20.0 30.0 45.0 65.0 90.0\n0.0\n"
                              "1000.0 1100.0 1300.0 1150.0 930.0 650.0 350.0 0.0\n";

float candela(const IesProfile& profile, double horizontal_deg, double vertical_deg)
{
    return profile.at(static_cast<float>(rad_from_deg(horizontal_deg)),
                      static_cast<float>(rad_from_deg(vertical_deg))) /
           watts_per_cd;
}

// `rows` are of the horizontal angles, of which there are `count`.
IesProfile of_type(int type,
                   const std::string& vertical,
                   int count,
                   const std::string& horizontal,
                   const std::string& rows)
{
    const auto spaces = std::count(vertical.begin(), vertical.end(), ' ');
    return parse_ies("IESNA:LM-63-2002\nTILT=NONE\n1 1000 1 " + std::to_string(spaces + 1) + " " +
                     std::to_string(count) + " " + std::to_string(type) + " 2 0 0 0 1 1 10\n" +
                     vertical + "\n" + horizontal + "\n" + rows + "\n");
}

TEST(IesProfile, a_published_example_gives_its_candela_at_its_angles)
{
    const IesProfile profile = parse_ies(downlight);
    const std::pair<double, float> measured[] = {{0, 1000}, {5, 1100}, {10, 1300}, {20, 1150},
                                                 {30, 930}, {45, 650}, {65, 350}};
    for (const auto& [vertical_deg, expected] : measured) {
        EXPECT_NEAR(candela(profile, 0.0, vertical_deg), expected, 0.01f) << vertical_deg;
        EXPECT_NEAR(candela(profile, 360.0, vertical_deg), expected, 0.01f) << vertical_deg;
    }
    EXPECT_EQ(candela(profile, 0.0, 90.0), 0.0f);
    EXPECT_EQ(candela(profile, 0.0, 120.0), 0.0f) << "above what was measured";
}

TEST(IesProfile, angles_between_are_cubic_and_symmetric_below_the_nadir)
{
    const IesProfile profile = parse_ies(downlight);
    // Catmull and Rom half way: (9 (b + c) - a - d) / 16.
    EXPECT_NEAR(candela(profile, 0.0, 15.0), (9 * (1300 + 1150) - 1100 - 930) / 16.0f, 0.1f);
    EXPECT_NEAR(candela(profile, 0.0, 2.5), (9 * (1000 + 1100) - 1100 - 1300) / 16.0f, 0.1f);
}

// Cycles 4.3.2's light of a point lamp with this profile on a plane, over that of the lamp alone,
// at angles from the nadir towards +X.
TEST(IesProfile, gives_what_cycles_gives)
{
    const IesProfile profile =
        of_type(1, "0 10 20 30 45 60 90", 1, "0", "1200 300 900 200 700 100 0");
    const std::pair<double, float> measured[] = {
        {14.853, 44.49152f}, {21.692, 65.20218f}, {33.544, 20.02964f}, {46.689, 52.45061f},
        {50.038, 43.38576f}, {57.852, 13.08657f}, {63.308, 5.14941f}};
    for (const auto& [vertical_deg, expected] : measured) {
        // Each figure is the mean of a pixel, 0.5 to 1.2 degrees wide.
        EXPECT_NEAR(candela(profile, 270.0, vertical_deg) * watts_per_cd, expected,
                    0.01f * expected)
            << vertical_deg;
    }
}

TEST(IesProfile, all_factors_of_a_file_multiply)
{
    std::string text = downlight;
    text.replace(text.find("1\n-1\n1\n8"), 8, "1\n-1\n2\n8");
    text.replace(text.find("1.0 1.0 0.0\n0.0 5.0"), 11, "0.5 3.0 0.0");
    EXPECT_NEAR(candela(parse_ies(text), 0.0, 10.0), 3.0f * 1300.0f, 0.1f);
}

TEST(IesProfile, a_tilt_table_is_passed_over)
{
    std::string text = downlight;
    text.replace(text.find("TILT=NONE\n"), 10, "TILT=INCLUDE\n1\n3\n0 45 90\n1.0 0.9 0.8\n");
    EXPECT_NEAR(candela(parse_ies(text), 0.0, 30.0), 930.0f, 0.1f);
}

TEST(IesProfile, a_quarter_is_mirrored_to_the_whole_circle)
{
    const IesProfile profile = of_type(1, "0 45 90", 3, "0 45 90", "9 100 0  9 200 0  9 300 0");
    for (const auto& [horizontal_deg, expected] : {std::pair(0.0, 100.0f),
                                                   {45.0, 200.0f},
                                                   {90.0, 300.0f},
                                                   {135.0, 200.0f},
                                                   {180.0, 100.0f},
                                                   {225.0, 200.0f},
                                                   {270.0, 300.0f},
                                                   {315.0, 200.0f},
                                                   {360.0, 100.0f}}) {
        EXPECT_NEAR(candela(profile, horizontal_deg, 45.0), expected, 0.01f) << horizontal_deg;
    }
}

TEST(IesProfile, a_half_that_begins_at_90_degrees_is_turned_to_0)
{
    const IesProfile profile = of_type(1, "0 45 90", 3, "90 180 270", "9 100 0  9 200 0  9 300 0");
    EXPECT_NEAR(candela(profile, 0.0, 45.0), 100.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 90.0, 45.0), 200.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 270.0, 45.0), 200.0f, 0.01f);
}

TEST(IesProfile, a_circle_without_its_last_angle_is_closed)
{
    const IesProfile profile = of_type(1, "0 45 90", 3, "0 120 240", "9 100 0  9 200 0  9 300 0");
    EXPECT_NEAR(candela(profile, 359.99, 45.0), 100.0f, 0.1f);
    EXPECT_NEAR(candela(profile, 240.0, 45.0), 300.0f, 0.01f);
}

TEST(IesProfile, type_b_is_mirrored_across_both_angles_which_are_exchanged)
{
    const IesProfile profile = of_type(2, "0 45 90", 2, "0 90", "100 50 0  20 10 0");
    // The file's middle is where both of the profile's angles are 90 degrees.
    EXPECT_NEAR(candela(profile, 90.0, 90.0), 100.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 45.0, 90.0), 50.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 135.0, 90.0), 50.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 90.0, 0.0), 20.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 45.0, 0.0), 10.0f, 0.01f);
}

TEST(IesProfile, type_a_runs_the_other_way_around_its_middle)
{
    const IesProfile profile = of_type(3, "-90 0 90", 3, "-90 0 90", "0 10 0  0 20 0  0 30 0");
    EXPECT_NEAR(candela(profile, 180.0, 90.0), 20.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 90.0, 90.0), 30.0f, 0.01f);
    EXPECT_NEAR(candela(profile, 269.99, 90.0), 10.0f, 0.1f);
    EXPECT_EQ(candela(profile, 10.0, 90.0), 0.0f) << "behind the lamp";
}

TEST(IesProfile, commas_and_line_ends_of_windows_separate_numbers_too)
{
    std::string text;
    for (const char c : downlight) {
        text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    }
    text.replace(text.find("0.0 5.0 10.0"), 12, "0.0,5.0, +10.0");
    EXPECT_NEAR(candela(parse_ies(text), 0.0, 10.0), 1300.0f, 0.1f);
}

std::string refusal(const std::string& text)
{
    try {
        static_cast<void>(parse_ies(text));
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(IesProfile, what_is_no_profile_is_refused_with_the_reason)
{
    EXPECT_EQ(refusal(""), "IES profile: it has no line that begins with TILT=");
    EXPECT_EQ(refusal("a picture, not TILT=NONE"),
              "IES profile: it has no line that begins with TILT=");
    EXPECT_EQ(refusal(downlight.substr(0, downlight.size() - 5)),
              "IES profile: it ends before the candela values");
    std::string text = downlight;
    text.replace(text.find("930.0"), 5, "dark!");
    EXPECT_EQ(refusal(text), "IES profile: the candela values is 'dark!'; expected a number");
    EXPECT_EQ(refusal("TILT=NONE\n1 -1 1 3 1 4 2 0 0 0 1 1 0"),
              "IES profile: the photometric type is 4; expected 1, 2 or 3");
    EXPECT_EQ(refusal("TILT=NONE\n1 -1 1 1e9 1 1 2 0 0 0 1 1 0"),
              "IES profile: the number of vertical angles is 1000000000.000000; expected 1 to "
              "100000");
    EXPECT_EQ(refusal("TILT=NONE\n1 -1 1 3 1 1 2 0 0 0 1 1 0  0 90 45  0  1 1 1"),
              "IES profile: the vertical angles do not ascend");
}

// A lamp that shines down measures from its nadir; turned over, from where it points then.
TEST(IesNode, measures_from_the_lamps_own_axis)
{
    const test::AskedNode node{
        .type = "TEX_IES", .options = {{"ies", downlight}}, .inputs = {{"Strength", V3f(2.0f)}}};
    const ShadingPoint below{.wo = V3f(0.0f, std::sin(0.1f), -std::cos(0.1f)),
                             .ng = V3f(0.0f, 0.0f, -1.0f),
                             .ns = V3f(0.0f, 0.0f, -1.0f)};
    test::MadeUpHit lamp;
    const IesProfile profile = parse_ies(downlight);
    EXPECT_NEAR(node("Fac", lamp, below).x, 2.0f * profile.at(float(pi), 0.1f), 1e-3f);
    lamp.facts.world_from_object.setAxisAngle(V3f(1.0f, 0.0f, 0.0f), float(pi));
    lamp.facts.object_from_world = lamp.facts.world_from_object.inverse();
    EXPECT_EQ(node("Fac", lamp, below).x, 0.0f) << "nothing is measured behind it";
}

}  // namespace
}  // namespace eye_render
