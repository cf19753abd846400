#include "made_up_hit.h"
#include "scattering.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::constant;
using test::direction_at;
using test::from_texture;
using test::MadeUpHit;
using test::up;

const Color3f orange(0.9f, 0.5f, 0.2f);
const ShadingPoint point{.wo = direction_at(30.0), .ng = up, .ns = up};

TEST(Material, diffuse_is_lambert_of_its_colour)
{
    const Material m{.surface = Surface::Diffuse, .base_color = constant(orange)};
    const V3f wi = direction_at(50.0, 40.0);
    const Bsdf bsdf = shade(m, point, MadeUpHit()).bsdf;
    EXPECT_LT((bsdf.evaluate(wi).value - orange * (wi.z / float(pi))).length(), 1e-6f);
}

TEST(Material, glossy_mirrors_its_colour_at_every_angle)
{
    const Material m{
        .surface = Surface::Glossy, .base_color = constant(orange), .roughness = constant(0.0f)};
    for (double angle_deg : {0.0, 89.0}) {
        const ShadingPoint seen{.wo = direction_at(angle_deg), .ng = up, .ns = up};
        const auto s = shade(m, seen, MadeUpHit()).bsdf.sample(0.5f, {0.5f, 0.5f});
        ASSERT_TRUE(s);
        EXPECT_LT((s->weight - orange).length(), 1e-5f) << angle_deg;
    }
}

TEST(Material, glass_tints_what_it_reflects_and_what_passes)
{
    const Material m{
        .surface = Surface::Glass, .base_color = constant(orange), .roughness = constant(0.0f)};
    const Bsdf bsdf = shade(m, point, MadeUpHit()).bsdf;
    for (float u : {0.0f, 0.999f}) {
        const auto s = bsdf.sample(u, {0.5f, 0.5f});
        ASSERT_TRUE(s);
        EXPECT_EQ(s->wi.z > 0.0f, u == 0.0f);
        EXPECT_LT((s->weight - orange).length(), 1e-5f) << u;
    }
}

TEST(Material, multiple_scattering_can_be_switched_off)
{
    Material m{
        .surface = Surface::Glossy, .base_color = constant(1.0f), .roughness = constant(1.0f)};
    const ShadingPoint above{.wo = up, .ng = up, .ns = up};
    EXPECT_NEAR(test::integrate(shade(m, above, MadeUpHit()).bsdf).value.x, 1.0, 0.01);
    m.multiple_scattering = false;
    EXPECT_NEAR(test::integrate(shade(m, above, MadeUpHit()).bsdf).value.x, 1.0 - std::log(2.0),
                1e-3);
}

TEST(Material, transparent_passes_its_colour_straight)
{
    const Material m{.surface = Surface::Transparent, .base_color = constant(orange)};
    const auto s = shade(m, point, MadeUpHit()).bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_straight);
    EXPECT_LT((s->weight - orange).length(), 1e-6f);
    EXPECT_EQ(straight_transmittance(m, MadeUpHit()), orange);
    EXPECT_EQ(straight_transmittance(Material{.surface = Surface::Glass}, MadeUpHit()),
              Color3f(0.0f));
}

TEST(Material, emission_glows_and_scatters_nothing)
{
    const Material m{.surface = Surface::Emission,
                     .emission_color = constant(orange),
                     .emission_strength = constant(10.0f)};
    const ShadedPoint shaded = shade(m, point, MadeUpHit());
    EXPECT_LT((shaded.emission - orange * 10.0f).length(), 1e-5f);
    EXPECT_TRUE(shaded.bsdf.is_delta_only());
    EXPECT_FALSE(shaded.bsdf.sample(0.5f, {0.5f, 0.5f}));
    EXPECT_EQ(emitted_radiance(m, MadeUpHit()), shaded.emission);
}

TEST(Material, says_what_it_may_do_before_any_hit)
{
    EXPECT_FALSE(Material{}.may_be_transparent());
    EXPECT_FALSE(Material{}.may_emit());
    EXPECT_TRUE(Material{.alpha = constant(0.99f)}.may_be_transparent());
    EXPECT_TRUE(Material{.alpha = from_texture(Channel::Alpha)}.may_be_transparent());
    EXPECT_TRUE(Material{.surface = Surface::Transparent}.may_be_transparent());
    EXPECT_FALSE(
        (Material{.surface = Surface::Diffuse, .alpha = constant(0.5f)}).may_be_transparent());
    const Material lamp{.emission_color = constant(1.0f), .emission_strength = from_texture()};
    EXPECT_TRUE(lamp.may_emit());
    EXPECT_FALSE((Material{.emission_color = constant(1.0f)}).may_emit());
}

TEST(Material, inputs_are_read_from_textures_and_attributes)
{
    MadeUpHit hit;
    hit.texel = Color4f(0.9f, 0.5f, 0.2f, 0.3f);
    hit.vertex_color = Color4f(0.1f, 0.2f, 0.3f, 1.0f);
    const auto albedo = [&](const MaterialInput& base_color) {
        const Material m{.surface = Surface::Diffuse, .base_color = base_color};
        return shade(m, point, hit).bsdf.albedo();
    };
    EXPECT_EQ(albedo(from_texture()), orange);
    EXPECT_EQ(albedo(from_texture(Channel::Alpha)), Color3f(0.3f));
    EXPECT_LT((albedo(from_texture(Channel::Luminance)) - Color3f(luminance(orange))).length(),
              1e-6f);
    EXPECT_EQ(albedo({.color_attribute = 0}), Color3f(0.1f, 0.2f, 0.3f));
}

TEST(Material, a_colour_counts_by_its_luminance_where_a_number_is_asked)
{
    MadeUpHit hit;
    hit.texel = Color4f(1.0f, 0.0f, 0.0f, 0.3f);
    EXPECT_NEAR(straight_transmittance({.alpha = from_texture()}, hit).x, 1.0f - 0.2126f, 1e-6f);
    EXPECT_NEAR(straight_transmittance({.alpha = from_texture(Channel::Alpha)}, hit).x, 0.7f,
                1e-6f);
}

}  // namespace
}  // namespace eye_render
