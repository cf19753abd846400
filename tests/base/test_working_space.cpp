#include "base/working_space.h"

#include <gtest/gtest.h>

#include <array>

namespace eye_render {
namespace {

constexpr std::array spaces{WorkingSpace::Rec709, WorkingSpace::Rec2020, WorkingSpace::AcesCg};

void expect_near(const V3f& found, const V3f& expected, float tolerance)
{
    EXPECT_LE((found - expected).length(), tolerance) << found << ", expected " << expected;
}

TEST(WorkingSpace, rec709_has_the_matrix_of_srgb)
{
    // IEC 61966-2-1, four digits, and of a white of as many.
    constexpr float digits = 3e-4f;
    expect_near(xyz_from_rgb({1, 0, 0}, WorkingSpace::Rec709), {0.4124f, 0.2126f, 0.0193f},
                digits);
    expect_near(xyz_from_rgb({0, 1, 0}, WorkingSpace::Rec709), {0.3576f, 0.7152f, 0.1192f},
                digits);
    expect_near(xyz_from_rgb({0, 0, 1}, WorkingSpace::Rec709), {0.1805f, 0.0722f, 0.9505f},
                digits);
}

TEST(WorkingSpace, rec2020_has_the_luminance_and_the_conversion_of_its_standards)
{
    // ITU-R BT.2020-2, table 4; ITU-R BT.2087-0, eq. 6.
    constexpr float digits = 1e-4f;
    expect_near(luminance_weights(WorkingSpace::Rec2020), {0.2627f, 0.6780f, 0.0593f}, digits);
    expect_near(rgb_from_rec709({1, 0, 0}, WorkingSpace::Rec2020), {0.6274f, 0.0691f, 0.0164f},
                digits);
    expect_near(rgb_from_rec709({0, 1, 0}, WorkingSpace::Rec2020), {0.3293f, 0.9195f, 0.0880f},
                digits);
    expect_near(rgb_from_rec709({0, 0, 1}, WorkingSpace::Rec2020), {0.0433f, 0.0114f, 0.8956f},
                digits);
}

TEST(WorkingSpace, acescg_is_what_opencolorio_makes_of_rec709)
{
    // Linear Rec.709 to ACEScg in the ACES configurations of OpenColorIO 2, D65 adapted to the
    // space's white by Bradford.
    constexpr float rounded_white = 1e-4f;  // of D65: here by five digits, there by chromaticity
    expect_near(rgb_from_rec709({1, 0, 0}, WorkingSpace::AcesCg),
                {0.6130974f, 0.0701937f, 0.0206156f}, rounded_white);
    expect_near(rgb_from_rec709({0, 1, 0}, WorkingSpace::AcesCg),
                {0.3395231f, 0.9163540f, 0.1095698f}, rounded_white);
    expect_near(rgb_from_rec709({0, 0, 1}, WorkingSpace::AcesCg),
                {0.0473795f, 0.0134524f, 0.8698147f}, rounded_white);
}

TEST(WorkingSpace, white_is_d65_and_stays_white)
{
    constexpr float rounding = 1e-6f;
    const V3f d65(0.95047f, 1.0f, 1.08883f);  // ASTM E308
    for (const WorkingSpace space : spaces) {
        expect_near(xyz_from_rgb(Color3f(1.0f), space), d65, rounding);
        expect_near(rgb_from_rec709(Color3f(1.0f), space), V3f(1.0f), rounding);
        EXPECT_NEAR(luminance_weights(space).dot(V3f(1.0f)), 1.0f, rounding);
    }
}

TEST(WorkingSpace, colours_come_back_from_xyz)
{
    constexpr float rounding = 1e-6f;
    const Color3f color(0.2f, 0.7f, 0.4f);
    for (const WorkingSpace space : spaces) {
        const V3f xyz = xyz_from_rgb(color, space);
        expect_near(rgb_from_xyz(xyz, space), color, rounding);
        EXPECT_NEAR(luminance_weights(space).dot(color), xyz.y, rounding);
    }
}

}  // namespace
}  // namespace eye_render
