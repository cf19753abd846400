#include "render/cryptomatte.h"
#include "render/integrator.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(MatteSums, things_are_ranked_by_what_they_cover_two_a_picture)
{
    MatteSums sums;
    sums.add(11.0f, 1.0);
    sums.add(22.0f, 1.0);
    sums.add(33.0f, 0.5);
    sums.add(22.0f, 3.0);
    std::array<float, 4> pixel{};
    sums.write(0, 10.0, pixel);
    EXPECT_EQ(pixel, (std::array{22.0f, 0.4f, 11.0f, 0.1f}));
    sums.write(1, 10.0, pixel);
    EXPECT_EQ(pixel, (std::array{33.0f, 0.05f, 0.0f, 0.0f}));
}

TEST(Cryptomatte, what_is_seen_through_a_surface_covers_the_rest)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -1),
                plain_material("BSDF_PRINCIPLED", {{"Alpha", V3f(0.25f)}}));
    test::place(data, test::square(1.0f), V3d(0, 0, -2), test::diffuse(0.5f));
    data.instances[0].matte = {.object = matte_id("veil"), .asset = matte_id("both")};
    data.instances[1].matte = {.object = matte_id("wall"), .asset = matte_id("both")};
    const Scene scene(data, V3d(0.0));
    const PassLayout layout({Pass::CryptoObject, Pass::CryptoAsset});
    PassValues values(layout);
    std::array<MatteSums, 2> sums;
    constexpr int count = 4000;
    for (int i = 0; i < count; ++i) {
        SampleSequence sequence(sobol_key(7, static_cast<std::uint64_t>(i)), 0);
        values.clear();
        static_cast<void>(trace_path(scene, {}, {.direction = V3f(0, 0, -1)}, sequence, &values));
        for (const MatteShare& matte : values.mattes()) {
            sums[matte.kind].add(matte.id, static_cast<double>(matte.coverage));
        }
    }
    std::array<float, 4> pixel{};
    sums[0].write(0, count, pixel);
    EXPECT_EQ(pixel[0], matte_id("wall"));
    // Three of four paths pass: 4 standard errors of their number.
    EXPECT_NEAR(pixel[1], 0.75f, 0.03f);
    EXPECT_EQ(pixel[2], matte_id("veil"));
    EXPECT_FLOAT_EQ(pixel[3], 0.25f);
    sums[1].write(0, count, pixel);
    EXPECT_EQ(pixel[0], matte_id("both"));
    EXPECT_NEAR(pixel[1], 1.0f, 0.03f);
}

}  // namespace
}  // namespace eye_render
