#include "shading/functions/cie_observer.h"
#include "shading/functions/spectral_colors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

TEST(SpectralColors, no_wavelength_is_brighter_than_the_display)
{
    float brightest = 0.0f;
    for (float nm = 375.0f; nm <= 785.0f; nm += 0.5f) {
        const Color3f rgb = rgb_of_wavelength(nm, WorkingSpace::Rec709);
        EXPECT_GE(std::min({rgb.x, rgb.y, rgb.z}), 0.0f) << nm;
        brightest = std::max(brightest, max_component(rgb));
    }
    constexpr float rounded_scale = 0.01f;  // Blender's divisor has three digits
    EXPECT_NEAR(brightest, 1.0f, rounded_scale);
}

TEST(SpectralColors, are_red_green_and_blue_in_the_order_of_their_waves)
{
    const Color3f blue = rgb_of_wavelength(450.0f, WorkingSpace::Rec709);
    const Color3f green = rgb_of_wavelength(530.0f, WorkingSpace::Rec709);
    const Color3f red = rgb_of_wavelength(630.0f, WorkingSpace::Rec709);
    EXPECT_EQ(max_component(blue), blue.z);
    EXPECT_EQ(max_component(green), green.y);
    EXPECT_EQ(max_component(red), red.x);
    EXPECT_EQ(rgb_of_wavelength(300.0f, WorkingSpace::Rec709), Color3f(0.0f));
    EXPECT_EQ(rgb_of_wavelength(800.0f, WorkingSpace::Rec709), Color3f(0.0f));
}

TEST(SpectralColors, equal_energy_has_equal_x_y_and_z)
{
    V3f sum(0.0f);
    for (int i = 0; i < observer_count; ++i) {
        sum += xyz_of_wavelength(observer_first_nm + float(i) * observer_step_nm);
    }
    constexpr float digits_of_table = 3e-5f;
    EXPECT_NEAR(sum.x / sum.y, 1.0f, digits_of_table);
    EXPECT_NEAR(sum.z / sum.y, 1.0f, digits_of_table);
}

TEST(SpectralColors, blackbodies_have_the_chromaticity_that_the_cie_gives)
{
    // Illuminant A is a blackbody of 2856 K: x 0.44757, y 0.40745 (CIE 15:2004).
    const V3f a(0.44757f / 0.40745f, 1.0f, (1.0f - 0.44757f - 0.40745f) / 0.40745f);
    constexpr float digits = 2e-3f;  // four of the table, and the older constant c2 of A
    EXPECT_LE(
        (rgb_of_blackbody(2856.0f, WorkingSpace::Rec709) - rgb_from_xyz(a, WorkingSpace::Rec709))
            .length(),
        digits);
}

TEST(SpectralColors, blackbodies_turn_from_red_to_blue_at_one_luminance)
{
    const Color3f ember = rgb_of_blackbody(1000.0f, WorkingSpace::Rec709);
    const Color3f sky = rgb_of_blackbody(12000.0f, WorkingSpace::Rec709);
    EXPECT_GT(ember.x, ember.y);
    EXPECT_GT(ember.y, ember.z);
    EXPECT_GT(sky.z, sky.x);
    for (const float kelvin : {3000.0f, 6500.0f, 11000.0f}) {
        constexpr float digits_of_luminance = 1e-3f;
        EXPECT_NEAR(luminance(rgb_of_blackbody(kelvin, WorkingSpace::Rec709)), 1.0f,
                    digits_of_luminance)
            << kelvin;
    }
}

TEST(SpectralColors, temperatures_out_of_range_are_the_nearest_in_it)
{
    EXPECT_EQ(rgb_of_blackbody(-3.0f, WorkingSpace::Rec709),
              rgb_of_blackbody(800.0f, WorkingSpace::Rec709));
    EXPECT_EQ(rgb_of_blackbody(1e30f, WorkingSpace::Rec709),
              rgb_of_blackbody(12000.0f, WorkingSpace::Rec709));
    EXPECT_EQ(rgb_of_blackbody(std::numeric_limits<float>::quiet_NaN(), WorkingSpace::Rec709),
              Color3f(0.0f));
}

}  // namespace
}  // namespace eye_render
