// What is left out of the paths of light, against derived answers.

#include "render/light_path_limits.h"

#include "base/units.h"
#include "estimate.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <limits>

namespace eye_render {
namespace {

using test::Estimate;
using test::estimate;
using test::expect_matches;

// Inside a closed box of that albedo whose walls shine with radiance 1.
SceneData furnace(float albedo)
{
    SceneData data;
    test::place(data, test::cube(1.0f), V3d(0.0), test::emissive_diffuse(albedo, 1.0f));
    return data;
}

// A wall of a material, 2 m ahead.
SceneData wall(const Material& material, const V3d& at = V3d(0.0, 0.0, -2.0))
{
    SceneData data;
    test::place(data, test::square(20.0f), at, material);
    return data;
}

const Material mirror =
    plain_material("BSDF_GLOSSY", {{"Color", V3f(1.0f)}, {"Roughness", V3f(0.0f)}});

TEST(LightPathLimits, diffuse_bounces_end_the_series_of_a_furnace)
{
    constexpr float a = 0.5f;
    const SceneData data = furnace(a);
    const Scene scene(data, V3d(0.0));
    for (const int bounces : {0, 1, 3}) {
        double expected = 0.0;
        // Light of the walls themselves, and scattered up to bounces + 1 times.
        for (int i = 0; i <= bounces + 1; ++i) {
            expected += std::pow(a, i);
        }
        SCOPED_TRACE(bounces);
        expect_matches(estimate(scene, {.max_bounces = 16, .limits = {.diffuse_bounces = bounces}},
                                {}, 20000),
                       expected);
        expect_matches(estimate(scene,
                                {.max_bounces = bounces,
                                 .limits = {.glossy_bounces = 0, .transmission_bounces = 0}},
                                {}, 20000),
                       expected);
    }
}

TEST(LightPathLimits, glossy_bounces_count_mirrors_alone)
{
    // Two mirrors face each other; every one of n reflections is white, then comes the lit side.
    SceneData data = wall(mirror);
    test::place(data, test::square(20.0f), V3d(0.0, 0.0, 2.0), mirror);
    data.world = test::even_world(1.0f);
    const Scene scene(data, V3d(0.0));
    const Ray askew{.direction = V3f(0.4f, 0.0f, -1.0f).normalized()};
    EXPECT_EQ(estimate(scene, {.max_bounces = 40}, askew, 4).mean, 1.0);
    const IntegratorSettings few{.max_bounces = 40, .limits = {.glossy_bounces = 4}};
    EXPECT_EQ(estimate(scene, few, askew, 4).mean, 0.0);
    const IntegratorSettings others{.max_bounces = 40,
                                    .limits = {.diffuse_bounces = 0, .transmission_bounces = 0}};
    EXPECT_EQ(estimate(scene, others, askew, 4).mean, 1.0);
}

TEST(LightPathLimits, transparent_bounces_stop_a_path_one_sheet_later_than_a_shadow_ray)
{
    const auto seen = [](int sheets, int limit) {
        SceneData data;
        for (int i = 0; i < sheets; ++i) {
            test::place(data, test::square(9.0f), V3d(0.0, 0.0, -1.0 - i),
                        test::transparent(1.0f));
        }
        data.world = test::even_world(1.0f);
        const Scene scene(data, V3d(0.0));
        return estimate(scene, {.limits = {.transparent_bounces = limit}}, {}, 4).mean;
    };
    EXPECT_EQ(seen(3, 2), 1.0);
    EXPECT_EQ(seen(4, 2), 0.0);

    const auto lit = [](int sheets, int limit) {
        SceneData data = wall(test::diffuse(0.5f));
        for (int i = 0; i < sheets; ++i) {
            test::place(data, test::square(9.0f), V3d(0.0, 0.0, 1.0 + i), test::transparent(1.0f));
        }
        data.lamps.push_back(test::point_lamp(V3d(0.0, 0.0, 20.0), 1000.0f));
        const Scene scene(data, V3d(0.0));
        return estimate(scene, {.limits = {.transparent_bounces = limit}}, {}, 4).mean;
    };
    EXPECT_GT(lit(2, 2), 0.0);
    EXPECT_EQ(lit(3, 2), 0.0);
}

// A diffuse floor under a roof of a material, in an even world.
double under_a_roof(const Material& roof, const LightPathLimits& limits)
{
    SceneData data = wall(test::diffuse(0.5f));
    test::place(data, test::square(1e3f), V3d(0.0, 0.0, 1.0), roof);
    data.world = test::even_world(1.0f);
    const Scene scene(data, V3d(0.0));
    return estimate(scene, {.max_bounces = 4, .limits = limits}, {}, 4000).mean;
}

TEST(LightPathLimits, without_caustics_glass_lets_no_light_to_a_diffuse_floor)
{
    // Of index 1, glass bends and reflects nothing.
    const Material glass = plain_material(
        "BSDF_GLASS", {{"Color", V3f(1.0f)}, {"Roughness", V3f(0.0f)}, {"IOR", V3f(1.0f)}});
    EXPECT_NEAR(under_a_roof(glass, {}), 0.5, 0.01);
    EXPECT_NEAR(under_a_roof(glass, {.reflective_caustics = false}), 0.5, 0.01);
    // What comes in below the roof's far edge.
    constexpr double sliver = 1e-4;
    EXPECT_LT(under_a_roof(glass, {.refractive_caustics = false}), sliver);
    const Material refraction = plain_material("BSDF_REFRACTION", {{"Roughness", V3f(0.0f)}});
    EXPECT_LT(under_a_roof(refraction, {.refractive_caustics = false}), sliver);
    const Material principled = plain_material(
        "BSDF_PRINCIPLED",
        {{"Base Color", V3f(1.0f)}, {"Transmission Weight", V3f(1.0f)}, {"Roughness", V3f(0.0f)}});
    EXPECT_LT(
        under_a_roof(principled, {.reflective_caustics = false, .refractive_caustics = false}),
        sliver);
    EXPECT_GT(under_a_roof(principled, {.reflective_caustics = false}), 0.2);
}

TEST(LightPathLimits, without_caustics_mirrors_light_no_diffuse_wall)
{
    // The wall sees nothing but the mirror, which sees the wall and what shines behind it.
    const auto seen = [](const Material& reflector, const LightPathLimits& limits) {
        SceneData data = wall(test::emissive_diffuse(0.5f, 1.0f));
        test::place(data, test::square(1e3f), V3d(0.0, 0.0, 1.0), reflector);
        const Scene scene(data, V3d(0.0));
        return estimate(scene, {.max_bounces = 1, .limits = limits}, {}, 20000);
    };
    const LightPathLimits none{.reflective_caustics = false};
    const Material metal = plain_material("BSDF_METALLIC", {});
    const Material principled =
        plain_material("BSDF_PRINCIPLED", {{"Metallic", V3f(1.0f)}, {"Roughness", V3f(0.3f)}});
    for (const Material& reflector : {mirror, metal, principled}) {
        EXPECT_GT(seen(reflector, {}).mean, 1.1);
        expect_matches(seen(reflector, none), 1.0);
    }
    // Only the diffuse base of a coated surface is left, and its coat takes nothing from it.
    const Material coated = plain_material("BSDF_PRINCIPLED", {{"Base Color", V3f(0.5f)},
                                                               {"Specular IOR Level", V3f(0.0f)},
                                                               {"Coat Weight", V3f(1.0f)}});
    const Estimate bare = seen(test::diffuse(0.5f), {});
    const Estimate without = seen(coated, none);
    EXPECT_NEAR(without.mean, bare.mean, 4.0 * (bare.standard_error + without.standard_error));
}

TEST(LightPathLimits, clamping_cuts_each_contribution_to_its_mean_and_keeps_its_hue)
{
    SceneData data = wall(
        plain_material("EMISSION", {{"Color", V3f(1.0f, 0.5f, 0.0f)}, {"Strength", V3f(40.0f)}}));
    const Scene scene(data, V3d(0.0));
    const auto seen = [&scene](const LightPathLimits& limits) {
        SampleSequence sequence(1, 0);
        return trace_path(scene, {.limits = limits}, {}, sequence).radiance;
    };
    EXPECT_EQ(seen({}), Color3f(40.0f, 20.0f, 0.0f));
    EXPECT_EQ(seen({.clamp_indirect = 2.0f}), Color3f(40.0f, 20.0f, 0.0f));
    const Color3f clamped = seen({.clamp_direct = 2.0f});
    EXPECT_LT((clamped - Color3f(4.0f, 2.0f, 0.0f)).length(), 1e-5f);
}

TEST(LightPathLimits, light_scattered_twice_is_indirect)
{
    // In the mirror, a wall that a lamp lights: light that was scattered twice.
    SceneData data = wall(mirror);
    test::place(data, test::square(20.0f), V3d(0.0, 0.0, 2.0), test::diffuse(0.5f));
    data.lamps.push_back(test::point_lamp(V3d(0.0, 0.0, 1.0), 1e4f));
    const Scene scene(data, V3d(0.0));
    const Ray askew{.direction = V3f(0.1f, 0.0f, -1.0f).normalized()};
    const auto seen = [&](const LightPathLimits& limits) {
        return estimate(scene, {.max_bounces = 1, .limits = limits}, askew, 4).mean;
    };
    const double all = seen({});
    EXPECT_GT(all, 1.0);
    EXPECT_EQ(seen({.clamp_direct = 0.1f}), all);
    EXPECT_NEAR(seen({.clamp_indirect = 0.1f}), 0.1, 1e-6);
}

TEST(LightPathLimits, filter_glossy_lets_lamps_be_found_in_mirrors_that_light_a_wall)
{
    // A point of light is not found in a mirror, unless it is roughened.
    SceneData data = wall(test::diffuse(0.5f));
    test::place(data, test::square(1e3f), V3d(0.0, 0.0, 1.0), mirror);
    LampData lamp = test::point_lamp(V3d(0.0, 0.0, -1.0), 100.0f);
    lamp.settings.radius = 0.0f;
    data.lamps.push_back(lamp);
    const Scene scene(data, V3d(0.0));
    const auto seen = [&scene](float filter) {
        return estimate(scene, {.max_bounces = 1, .limits = {.filter_glossy = filter}}, {}, 4000);
    };
    const double direct = seen(0.0f).mean;
    // Bounces are likelier than a hundredth, all but those along the wall.
    EXPECT_NEAR(seen(0.01f).mean, direct, 0.01 * direct);
    EXPECT_GT(seen(1.0f).mean, 1.03 * direct);
}

TEST(LightPathLimits, refuses_what_is_out_of_range)
{
    EXPECT_NO_THROW(require_valid(LightPathLimits{}));
    EXPECT_THROW(require_valid(LightPathLimits{.diffuse_bounces = -1}), std::invalid_argument);
    EXPECT_THROW(require_valid(LightPathLimits{.transparent_bounces = most_bounces + 1}),
                 std::invalid_argument);
    EXPECT_THROW(require_valid(LightPathLimits{.filter_glossy = -0.5f}), std::invalid_argument);
    EXPECT_THROW(
        require_valid(LightPathLimits{.clamp_direct = std::numeric_limits<float>::quiet_NaN()}),
        std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
