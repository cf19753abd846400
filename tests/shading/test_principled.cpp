#include "made_up_hit.h"
#include "scattering.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

using test::constant;
using test::direction_at;
using test::MadeUpHit;
using test::up;

const Color3f blue(0.1f, 0.3f, 0.9f);

ShadingPoint seen_at(double angle_deg)
{
    return {.wo = direction_at(angle_deg), .ng = up, .ns = up};
}

Bsdf shaded(const Material& material, double angle_deg = 30.0)
{
    return shade(material, seen_at(angle_deg), MadeUpHit()).bsdf;
}

struct Furnace {
    double returned = 0.0;
    double standard_error = 0.0;
};

// Light returned for light from all around, straight and mirrored light included.
Furnace furnace(const Bsdf& bsdf)
{
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    constexpr int samples = 8000;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (int i = 0; i < samples; ++i) {
        const float u_lobe = uniform(random);
        const float x = uniform(random);
        if (const auto s = bsdf.sample(u_lobe, {x, uniform(random)})) {
            const auto weight = double(luminance(s->weight));
            sum += weight;
            sum_of_squares += weight * weight;
        }
    }
    const double mean = sum / samples;
    return {mean, std::sqrt(std::max(0.0, sum_of_squares / samples - mean * mean) / samples)};
}

TEST(Principled, white_returns_all_light_over_all_its_inputs)
{
    // What one layer keeps from the next, and what compensation gives back, are read from tables.
    // Their linear interpolation is off by this much at most, between the few nodes that a
    // dielectric of large index has near grazing angles. Nothing else is lost.
    constexpr double interpolation_error = 8e-3;
    for (float metallic : {0.0f, 0.5f, 1.0f}) {
        for (float transmission : {0.0f, 0.5f, 1.0f}) {
            for (float roughness : {0.0f, 0.2f, 0.6f, 1.0f}) {
                for (float specular : {0.0f, 0.5f, 1.0f}) {
                    for (float ior : {1.0f, 1.45f, 2.5f}) {
                        const Material m{.base_color = constant(1.0f),
                                         .metallic = constant(metallic),
                                         .roughness = constant(roughness),
                                         .specular = constant(specular),
                                         .ior = constant(ior),
                                         .transmission = constant(transmission),
                                         .alpha = constant(0.9f)};
                        for (double angle_deg : {0.0, 60.0, 80.0}) {
                            const Furnace f = furnace(shaded(m, angle_deg));
                            EXPECT_NEAR(f.returned, 1.0,
                                        4.0 * f.standard_error + interpolation_error)
                                << "metallic " << metallic << ", transmission " << transmission
                                << ", roughness " << roughness << ", specular " << specular
                                << ", ior " << ior << ", " << angle_deg << " deg";
                        }
                    }
                }
            }
        }
    }
}

TEST(Principled, white_at_default_settings_is_almost_white)
{
    for (float roughness : {0.0f, 0.25f, 0.5f, 1.0f}) {
        const Material m{.base_color = constant(1.0f), .roughness = constant(roughness)};
        EXPECT_NEAR(furnace(shaded(m)).returned, 1.0, 0.01) << roughness;
    }
}

TEST(Principled, without_specular_is_lambert)
{
    const Material m{.base_color = constant(blue), .specular = constant(0.0f)};
    const V3f wi = direction_at(40.0, 100.0);
    const Color3f expected = blue * (wi.z / float(pi));
    EXPECT_LT((shaded(m).evaluate(wi).value - expected).length(), 1e-6f);
}

TEST(Principled, specular_doubles_the_reflectance_from_half_to_one)
{
    const auto mirrored = [](float specular) {
        const Material m{.base_color = constant(0.0f),
                         .roughness = constant(0.0f),
                         .specular = constant(specular)};
        return shaded(m, 0.0).sample(0.5f, {0.5f, 0.5f})->weight.x;
    };
    EXPECT_NEAR(mirrored(0.5f), 0.04f, 1e-5f);
    EXPECT_NEAR(mirrored(1.0f), 0.08f, 1e-5f);
}

TEST(Principled, metal_has_its_base_colour_from_above_and_is_white_at_grazing)
{
    const Material m{
        .base_color = constant(blue), .metallic = constant(1.0f), .roughness = constant(0.0f)};
    EXPECT_LT((shaded(m, 0.0).sample(0.5f, {0.5f, 0.5f})->weight - blue).length(), 1e-5f);
    EXPECT_GT(shaded(m, 89.9).sample(0.5f, {0.5f, 0.5f})->weight.x, 0.98f);
}

TEST(Principled, glass_is_tinted_once_in_and_once_out)
{
    // Light that passes two boundaries takes the base colour: the square root at each.
    const Material m{
        .base_color = constant(blue), .roughness = constant(0.0f), .transmission = constant(1.0f)};
    const auto s = shaded(m, 0.0).sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_LT(s->wi.z, 0.0f);
    // Over the share that is sampled as passing.
    EXPECT_NEAR(s->weight.x / s->weight.z, std::sqrt(blue.x / blue.z), 1e-5f);
}

TEST(Principled, index_is_inverted_from_the_back)
{
    const Material m{.roughness = constant(0.0f), .transmission = constant(1.0f)};
    ShadingPoint point = seen_at(50.0);
    point.backfacing = true;
    // Beyond the critical angle of 41.8 degrees nothing passes.
    const auto s = shade(m, point, MadeUpHit()).bsdf.sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_GT(s->wi.z, 0.0f);
    EXPECT_NEAR(s->weight.x, 1.0f, 1e-5f);
}

TEST(Principled, alpha_passes_light_straight_and_dims_the_rest_and_the_glow)
{
    const Material m{.base_color = constant(blue),
                     .specular = constant(0.0f),
                     .alpha = constant(0.25f),
                     .emission_color = constant(1.0f),
                     .emission_strength = constant(4.0f)};
    const ShadedPoint point = shade(m, seen_at(30.0), MadeUpHit());
    EXPECT_LT((point.bsdf.albedo() - blue * 0.25f).length(), 1e-6f);
    EXPECT_NEAR(point.emission.x, 1.0f, 1e-6f);
    EXPECT_EQ(straight_transmittance(m, MadeUpHit()), Color3f(0.75f));
    EXPECT_EQ(emitted_radiance(m, MadeUpHit()), point.emission);
    EXPECT_NEAR(furnace(point.bsdf).returned, 0.75 + 0.25 * double(luminance(blue)), 0.01);
}

TEST(Principled, a_hole_is_nothing_but_straight_light)
{
    const Material m{.alpha = constant(0.0f),
                     .emission_color = constant(1.0f),
                     .emission_strength = constant(4.0f)};
    const ShadedPoint point = shade(m, seen_at(30.0), MadeUpHit());
    EXPECT_TRUE(point.bsdf.is_delta_only());
    EXPECT_EQ(point.emission, Color3f(0.0f));
    const auto s = point.bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s && s->is_straight);
    EXPECT_EQ(s->weight, Color3f(1.0f));
}

TEST(Principled, constant_inputs_ask_nothing_of_the_hit)
{
    MadeUpHit hit;
    const ShadedPoint point = shade(Material{}, seen_at(30.0), hit);
    EXPECT_EQ(hit.questions, 0);
    EXPECT_FALSE(point.bsdf.is_delta_only());
}

TEST(Principled, nonsense_inputs_give_finite_light)
{
    for (float bad : {NAN, INFINITY, -INFINITY, -3.0f, 1e30f, 0.0f}) {
        for (float transmission : {0.0f, 0.5f}) {
            const Material m{.base_color = constant(bad),
                             .metallic = constant(transmission == 0.0f ? bad : 0.0f),
                             .roughness = constant(bad),
                             .specular = constant(bad),
                             .ior = constant(bad),
                             .transmission = constant(transmission),
                             .alpha = constant(0.5f),
                             .emission_color = constant(bad),
                             .emission_strength = constant(bad)};
            for (double angle_deg : {0.0, 60.0, 89.9999}) {
                const ShadedPoint point = shade(m, seen_at(angle_deg), MadeUpHit());
                EXPECT_TRUE(test::is_finite(point.emission)) << bad;
                EXPECT_TRUE(test::is_finite(point.bsdf.albedo())) << bad;
                for (float u : {0.0f, 0.3f, 0.6f, 0.99999f}) {
                    const auto s = point.bsdf.sample(u, {u, 1.0f - u * 0.999f});
                    if (s) {
                        EXPECT_TRUE(test::is_finite(s->weight)) << bad << " at " << angle_deg;
                        EXPECT_TRUE(std::isfinite(s->pdf)) << bad << " at " << angle_deg;
                        EXPECT_NEAR(s->wi.length(), 1.0f, 1e-4f) << bad << " at " << angle_deg;
                    }
                }
                const BsdfValue f = point.bsdf.evaluate(direction_at(angle_deg, 180.0));
                EXPECT_TRUE(test::is_finite(f.value) && std::isfinite(f.pdf)) << bad;
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
