#include "estimate.h"
#include "render/pixel_means.h"
#include "render/shadow_catcher.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(ShadowCatcher, the_factor_is_what_objects_leave_of_the_light)
{
    const CaughtLight half_dark{
        .all = V3d(0.3), .bare = V3d(0.6), .behind = V3d(2.0), .matte_alpha = 0.0};
    EXPECT_EQ(catcher_factor(half_dark), V3d(0.5));
    EXPECT_EQ(over_nothing(half_dark), (std::array{0.0, 0.0, 0.0, 0.5}));
    EXPECT_EQ(over_world(half_dark), (std::array{1.0, 1.0, 1.0, 1.0}));
    EXPECT_EQ(without_shadow(half_dark), (std::array{0.0, 0.0, 0.0, 0.0}));
}

TEST(ShadowCatcher, what_is_unlit_without_objects_is_not_darkened)
{
    const CaughtLight red{.all = V3d(0.3, 0.0, 0.0),
                          .bare = V3d(0.3, 0.0, 0.0),
                          .behind = V3d(1.0),
                          .matte_alpha = 0.0};
    EXPECT_EQ(catcher_factor(red), V3d(1.0));
    EXPECT_EQ(over_nothing(red)[3], 0.0);
    const CaughtLight unlit{.behind = V3d(2.0), .matte_alpha = 0.0};
    EXPECT_EQ(over_world(unlit), (std::array{2.0, 2.0, 2.0, 1.0}));
}

TEST(ShadowCatcher, where_there_is_none_the_picture_is_as_it_is)
{
    const CaughtLight object{.all = V3d(0.3), .matte = V3d(0.3)};
    EXPECT_EQ(catcher_factor(object), V3d(1.0));
    EXPECT_EQ(over_world(object), (std::array{0.3, 0.3, 0.3, 1.0}));
    EXPECT_EQ(over_nothing(object), (std::array{0.3, 0.3, 0.3, 1.0}));
}

TEST(ShadowCatcher, paths_tell_the_light_with_and_without_objects)
{
    SceneData data;
    data.world = test::even_world(1.0f);
    test::place(data, test::square(3.0f), V3d(0, 0, -3), test::diffuse(0.5f));
    test::place(data, test::square(3.0f), V3d(0, 0, 1), test::diffuse(0.0f));
    data.instances[0].is_shadow_catcher = true;
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({Pass::ShadowCatcher}, {.has_shadow_catcher = true});
    PassValues values(layout);
    double bare = 0.0;
    double all = 0.0;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        SampleSequence sequence = test::sequence_of(i);
        values.clear();
        all += static_cast<double>(
            trace_path(scene, {}, {.direction = V3f(0, 0, -1)}, sequence, &values).radiance.x);
        const std::span<const float> channels = values.channels();
        bare += static_cast<double>(channels[layout.catcher()->bare]);
        EXPECT_EQ(channels[layout.catcher()->matte], 0.0f);
        EXPECT_EQ(channels[layout.catcher()->behind], 1.0f);
        EXPECT_EQ(channels[layout.catcher()->matte_alpha], 0.0f);
    }
    EXPECT_NEAR(bare / count, 0.5, 0.01);  // 4 standard errors
    EXPECT_LT(all, 0.75 * bare);
}

}  // namespace
}  // namespace eye_render
