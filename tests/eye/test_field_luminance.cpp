// The weighted luminance of a picture, and its solid angle.

#include "eye/field_luminance.h"

#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace eye_render {
namespace {

constexpr double digits_of_weights = 1e-6;  // of a white pixel: those of the standard are floats

TEST(FieldLuminance, of_a_flat_picture_is_its_colours_luminance)
{
    const std::vector<Color3f> pixels(6 * 4, Color3f(1.0f, 0.5f, 0.25f));
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 6,
                                      {.weights = paper_luminance_weights, .cd_m2_per_unit = 100}),
                100.0 * (0.3 + 0.59 * 0.5 + 0.11 * 0.25), 1e-9);
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 6), 179.0 * (0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25),
                0.01);  // as printed in the standard
}

TEST(FieldLuminance, weighs_pixels_by_the_papers_gaussian)
{
    // 4 x 2 pixels: a is +-0.25 and +-0.75, b is +-0.5; one white pixel at a = 0.75, b = -0.5.
    std::vector<Color3f> pixels(8, Color3f(0.0f));
    pixels[3] = Color3f(1.0f);
    const double sigma = 0.4;
    const auto gaussian = [&](double a, double b) {
        return std::exp(-(a * a + b * b) / (2.0 * sigma * sigma));
    };
    const double total = 4.0 * (gaussian(0.25, 0.5) + gaussian(0.75, 0.5));
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 4, {.sigma = sigma, .cd_m2_per_unit = 1.0}),
                gaussian(0.75, 0.5) / total, digits_of_weights);
}

TEST(FieldLuminance, of_a_wide_gaussian_is_the_plain_mean_and_of_a_narrow_one_the_centre)
{
    std::vector<Color3f> pixels(4 * 4, Color3f(0.0f));
    pixels[0] = Color3f(16.0f);
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 4, {.sigma = 1e9, .cd_m2_per_unit = 1.0}), 1.0,
                digits_of_weights);
    pixels[5] = pixels[6] = pixels[9] = pixels[10] = Color3f(3.0f);
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 4, {.sigma = 1e-6, .cd_m2_per_unit = 1.0}), 3.0,
                digits_of_weights);
}

TEST(FieldLuminance, ignores_pixels_that_are_no_numbers)
{
    std::vector<Color3f> pixels(9, Color3f(2.0f));
    pixels[4] = Color3f(std::numeric_limits<float>::quiet_NaN());
    pixels[0] = Color3f(std::numeric_limits<float>::infinity());
    EXPECT_NEAR(field_luminance_cd_m2(pixels, 3, {.cd_m2_per_unit = 1.0}), 2.0, digits_of_weights);
    pixels.assign(9, Color3f(std::numeric_limits<float>::quiet_NaN()));
    EXPECT_EQ(field_luminance_cd_m2(pixels, 3), 0.0);
}

TEST(FieldLuminance, refuses_what_is_no_picture)
{
    const std::vector<Color3f> pixels(6);
    EXPECT_THROW(static_cast<void>(field_luminance_cd_m2({}, 1)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(field_luminance_cd_m2(pixels, 4)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(field_luminance_cd_m2(pixels, 0)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(field_luminance_cd_m2(pixels, 3, {.sigma = 0.0})),
                 std::invalid_argument);
    EXPECT_THROW(static_cast<void>(field_luminance_cd_m2(pixels, 3, {.cd_m2_per_unit = NAN})),
                 std::invalid_argument);
}

TEST(FieldArea, of_a_cubes_face_is_a_sixth_of_the_sphere_however_it_is_cut)
{
    const double face_deg2 = 4.0 * pi / 6.0 * std::pow(180.0 / pi, 2);
    EXPECT_NEAR(field_area_deg2({}), face_deg2, 1e-9);
    EXPECT_NEAR(field_area_deg2({.right = 0.3}) + field_area_deg2({.left = 0.3}), face_deg2, 1e-9);
    EXPECT_NEAR(field_area_deg2({.left = 1.0, .right = -1.0}), face_deg2, 1e-9) << "mirrored";
}

}  // namespace
}  // namespace eye_render
