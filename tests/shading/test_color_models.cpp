#include "shading/functions/color_models.h"

#include <gtest/gtest.h>

#include <limits>

namespace eye_render {
namespace {

constexpr float rounding = 8.0f * std::numeric_limits<float>::epsilon();

constexpr float shares[] = {0.0f, 0.2f, 0.5f, 0.75f, 1.0f};

TEST(ColorModels, go_and_come_back)
{
    for (const float r : shares) {
        for (const float g : shares) {
            for (const float b : shares) {
                const Color3f rgb(r, g, b);
                EXPECT_LE((rgb_from_hsv(hsv_from_rgb(rgb)) - rgb).length(), rounding) << rgb;
                EXPECT_LE((rgb_from_hsl(hsl_from_rgb(rgb)) - rgb).length(), rounding) << rgb;
            }
        }
    }
}

TEST(ColorModels, value_and_saturation_may_exceed_the_display)
{
    const Color3f bright(7.0f, 2.0f, 3.5f);
    EXPECT_LE((rgb_from_hsv(hsv_from_rgb(bright)) - bright).length(), 7.0f * rounding);
    EXPECT_EQ(hsv_from_rgb(bright).z, 7.0f);
}

TEST(ColorModels, primaries_are_thirds_of_a_turn_apart)
{
    const Color3f primaries[] = {{1.0f, 0.0f, 0.0f}, {0.0f, 1.0f, 0.0f}, {0.0f, 0.0f, 1.0f}};
    for (int i = 0; i < 3; ++i) {
        const float hue = static_cast<float>(i) / 3.0f;
        EXPECT_NEAR(hsv_from_rgb(primaries[i]).x, hue, rounding);
        EXPECT_NEAR(hsl_from_rgb(primaries[i]).x, hue, rounding);
        EXPECT_EQ(hsl_from_rgb(primaries[i]).z, 0.5f);
    }
}

TEST(ColorModels, greys_have_neither_hue_nor_saturation)
{
    for (const float grey : shares) {
        EXPECT_EQ(hsv_from_rgb(Color3f(grey)), V3f(0.0f, 0.0f, grey));
        EXPECT_EQ(hsl_from_rgb(Color3f(grey)), V3f(0.0f, 0.0f, grey));
    }
}

}  // namespace
}  // namespace eye_render
