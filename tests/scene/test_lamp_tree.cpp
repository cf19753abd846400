// Lamps found through the tree are those that a look at every lamp finds.

#include "scene/lamp_tree.h"

#include "base/sobol.h"
#include "base/warp.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <set>

namespace eye_render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Lamps of all kinds with an extent, scattered over a box.
std::vector<Lamp> scattered_lamps(int count)
{
    std::vector<Lamp> lamps;
    for (int i = 0; i < count; ++i) {
        const auto u = sobol_4d(3, static_cast<std::uint32_t>(i), 0);
        LampSettings settings{.kind = static_cast<LampKind>(i % 4),
                              .color = Color3f(1.0f),
                              .radius = 0.1f + u[3],
                              .soft_falloff = i % 3 == 0,
                              .angle_rad = 0.2f,
                              .spot_angle_rad = 2.0f,
                              .shape = i % 8 < 4 ? LampShape::Rectangle : LampShape::Disk,
                              .size_x = 1.0f + u[3],
                              .size_y = 0.3f};
        settings.world_from_light.setEulerAngles(V3f(u[0], u[1], u[2]) * 6.0f);
        settings.world_from_light[3][0] = 40.0f * u[0] - 20.0f;
        settings.world_from_light[3][1] = 40.0f * u[1] - 20.0f;
        settings.world_from_light[3][2] = 40.0f * u[2] - 20.0f;
        lamps.push_back(make_lamp(settings));
    }
    return lamps;
}

TEST(LampTree, finds_every_lamp_that_a_ray_meets_and_looks_at_few_others)
{
    const std::vector<Lamp> lamps = scattered_lamps(1000);
    std::vector<std::uint32_t> all(lamps.size());
    std::iota(all.begin(), all.end(), 0u);
    const LampTree tree(lamps, all);
    int met = 0;
    std::size_t looks = 0;
    constexpr std::uint32_t rays = 500;
    for (std::uint32_t i = 0; i < rays; ++i) {
        const auto u = sobol_4d(5, i, 0);
        const V3f origin(10.0f * u[2] - 5.0f, 0.0f, 3.0f);
        // Along the axes, too, where the boxes' sides are.
        const V3f direction =
            i % 10 == 0 ? V3f(0.0f, 1.0f, 0.0f) : sample_uniform_sphere({u[0], u[1]});
        const float t_max = i % 2 == 0 ? infinity : 15.0f;
        std::set<std::uint32_t> found;
        tree.visit(origin, direction, t_max, [&](std::uint32_t number) {
            ++looks;
            EXPECT_TRUE(found.insert(number).second) << "twice";
        });
        for (const std::uint32_t number : all) {
            if (lamp_hit(lamps[number], origin, direction, t_max)) {
                ++met;
                EXPECT_TRUE(found.contains(number)) << number << " of ray " << i;
            }
        }
    }
    EXPECT_GT(met, 200);
    // The 250 suns are always looked at.
    EXPECT_LT(looks, rays * 300);
}

TEST(LampTree, finds_only_those_it_was_given)
{
    const std::vector<Lamp> lamps = scattered_lamps(8);
    const std::vector<std::uint32_t> one{5};
    const V3f to_lamp = lamps[5].position;
    std::vector<std::uint32_t> found;
    LampTree(lamps, one)
        .visit(V3f(0.0f), to_lamp.normalized(), infinity,
               [&](std::uint32_t number) { found.push_back(number); });
    EXPECT_EQ(found, one);
    LampTree().visit(V3f(0.0f), V3f(1, 0, 0), infinity,
                     [&](std::uint32_t) { FAIL() << "there are no lamps"; });
}

}  // namespace
}  // namespace eye_render
