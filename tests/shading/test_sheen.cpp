// The sheen's table, and what it is built of.

#include "scattering.h"
#include "shading/diffuse_lobe.h"
#include "shading/sheen.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

TEST(Sheen, is_brighter_the_rougher_and_the_more_grazing)
{
    for (float roughness : {0.2f, 0.4f, 0.6f, 0.8f}) {
        for (float cosine : {0.2f, 0.5f, 0.9f}) {
            const SheenTransform here = sheen_transform(roughness, cosine);
            EXPECT_LT(here.albedo, sheen_transform(roughness + 0.2f, cosine).albedo);
            EXPECT_GT(here.albedo, sheen_transform(roughness, cosine + 0.1f).albedo);
            EXPECT_LT(here.albedo, 1.0f);
        }
    }
}

TEST(Sheen, scatters_the_share_that_the_table_says)
{
    for (float roughness : {0.3f, 0.6f, 1.0f}) {
        for (double angle_deg : {10.0, 50.0, 80.0}) {
            Bsdf bsdf(direction_at(angle_deg), up);
            const float share =
                add_sheen(bsdf, Color3f(1.0f), roughness, up, up, direction_at(angle_deg));
            EXPECT_NEAR(test::integrate(bsdf).value.x, double(share), 2e-3)
                << roughness << ", " << angle_deg << " deg";
            EXPECT_EQ(bsdf.albedo(), Color3f(share));
        }
    }
}

TEST(Sheen, is_none_where_the_table_has_none)
{
    Bsdf bsdf(up, up);
    EXPECT_EQ(add_sheen(bsdf, Color3f(1.0f), 0.0f, up, up, up), 0.0f);
    EXPECT_TRUE(bsdf.is_delta_only());
}

TEST(Sheen, leans_towards_the_viewer)
{
    Bsdf bsdf(direction_at(70.0), up);
    static_cast<void>(add_sheen(bsdf, Color3f(1.0f), 0.4f, up, up, direction_at(70.0)));
    const float back = bsdf.evaluate(direction_at(60.0, 0.0)).value.x;
    const float away = bsdf.evaluate(direction_at(60.0, 180.0)).value.x;
    EXPECT_GT(back, 1.05f * away);
}

}  // namespace
}  // namespace eye_render
