// The Principled BSDF as a function of its inputs.

#include "scattering.h"
#include "shading/node.h"
#include "shading/principled.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

const Color3f white(1.0f);
const Color3f blue(0.1f, 0.3f, 0.9f);

ShadingPoint seen_at(double angle_deg)
{
    return {.wo = direction_at(angle_deg), .ng = up, .ns = up};
}

Bsdf shaded(const PrincipledInputs& inputs, const ShadingPoint& point)
{
    Bsdf bsdf(point.wo, point.ng);
    add_principled(bsdf, inputs, 1.0f, point);
    return bsdf;
}

Bsdf shaded(const PrincipledInputs& inputs, double angle_deg = 30.0)
{
    return shaded(inputs, seen_at(angle_deg));
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
                        const PrincipledInputs m{.base_color = white,
                                                 .metallic = metallic,
                                                 .roughness = roughness,
                                                 .ior = ior,
                                                 .alpha = 0.9f,
                                                 .specular_ior_level = specular,
                                                 .transmission_weight = transmission};
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
        const PrincipledInputs m{.base_color = white, .roughness = roughness};
        EXPECT_NEAR(furnace(shaded(m)).returned, 1.0, 0.01) << roughness;
    }
}

TEST(Principled, without_specular_is_lambert)
{
    const PrincipledInputs m{.base_color = blue, .specular_ior_level = 0.0f};
    const V3f wi = direction_at(40.0, 100.0);
    const Color3f expected = blue * (wi.z / float(pi));
    EXPECT_LT((shaded(m).evaluate(wi).value - expected).length(), 1e-6f);
}

TEST(Principled, specular_doubles_the_reflectance_from_half_to_one)
{
    const auto mirrored = [](float specular) {
        const PrincipledInputs m{
            .base_color = Color3f(0.0f), .roughness = 0.0f, .specular_ior_level = specular};
        return shaded(m, 0.0).sample(0.5f, {0.5f, 0.5f})->weight.x;
    };
    EXPECT_NEAR(mirrored(0.5f), 0.04f, 1e-5f);
    EXPECT_NEAR(mirrored(1.0f), 0.08f, 1e-5f);
}

TEST(Principled, metal_has_its_base_colour_from_above_and_is_white_at_grazing)
{
    const PrincipledInputs m{.base_color = blue, .metallic = 1.0f, .roughness = 0.0f};
    EXPECT_LT((shaded(m, 0.0).sample(0.5f, {0.5f, 0.5f})->weight - blue).length(), 1e-5f);
    EXPECT_GT(shaded(m, 89.9).sample(0.5f, {0.5f, 0.5f})->weight.x, 0.98f);
}

TEST(Principled, glass_is_tinted_once_in_and_once_out)
{
    // Light that passes two boundaries takes the base colour: the square root at each.
    const PrincipledInputs m{.base_color = blue, .roughness = 0.0f, .transmission_weight = 1.0f};
    const auto s = shaded(m, 0.0).sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_LT(s->wi.z, 0.0f);
    // Over the share that is sampled as passing.
    EXPECT_NEAR(s->weight.x / s->weight.z, std::sqrt(blue.x / blue.z), 1e-5f);
}

TEST(Principled, index_is_inverted_from_the_back)
{
    const PrincipledInputs m{.roughness = 0.0f, .transmission_weight = 1.0f};
    ShadingPoint point = seen_at(50.0);
    point.backfacing = true;
    // Beyond the critical angle of 41.8 degrees nothing passes.
    const auto s = shaded(m, point).sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_GT(s->wi.z, 0.0f);
    EXPECT_NEAR(s->weight.x, 1.0f, 1e-5f);
}

TEST(Principled, alpha_passes_light_straight_and_dims_the_rest_and_the_glow)
{
    const PrincipledInputs m{.base_color = blue,
                             .alpha = 0.25f,
                             .specular_ior_level = 0.0f,
                             .emission_color = white,
                             .emission_strength = 4.0f};
    const Bsdf bsdf = shaded(m);
    EXPECT_LT((bsdf.albedo() - blue * 0.25f).length(), 1e-6f);
    EXPECT_NEAR(principled_emission(m, seen_at(30.0)).x, 1.0f, 1e-6f);
    EXPECT_NEAR(furnace(bsdf).returned, 0.75 + 0.25 * double(luminance(blue)), 0.01);
}

TEST(Principled, a_hole_is_nothing_but_straight_light)
{
    const PrincipledInputs m{.alpha = 0.0f, .coat_weight = 1.0f, .emission_strength = 4.0f};
    const Bsdf bsdf = shaded(m);
    EXPECT_TRUE(bsdf.is_delta_only());
    EXPECT_EQ(principled_emission(m, seen_at(30.0)), Color3f(0.0f));
    const auto s = bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s && s->is_straight);
    EXPECT_EQ(s->weight, white);
}

// A base that would return all light, under each layer. `kept_back` bounds what the layers lose:
// Cycles' rule takes the brightest colour of a layer's albedo from all colours below, and a rough
// coat's albedo for a smooth one's.
TEST(Principled, layers_return_no_more_light_than_comes_in)
{
    constexpr double table_error = 8e-3;
    struct Case {
        const char* name;
        PrincipledInputs inputs;
        double kept_back;
    };
    const Case cases[] = {
        {"coat", {.base_color = white, .coat_weight = 1.0f, .coat_roughness = 0.0f}, 0.01},
        {"rough coat", {.base_color = white, .coat_weight = 1.0f, .coat_roughness = 0.6f}, 0.2},
        {"sheen", {.base_color = white, .sheen_weight = 1.0f}, 0.01},
        {"all",
         {.base_color = white,
          .metallic = 0.3f,
          .roughness = 0.4f,
          .diffuse_roughness = 0.7f,
          .transmission_weight = 0.4f,
          .coat_weight = 0.5f,
          .coat_roughness = 0.1f,
          .sheen_weight = 0.4f},
         0.05},
        {"rough diffuse", {.base_color = white, .diffuse_roughness = 1.0f}, 0.01},
        {"brushed metal", {.base_color = white, .metallic = 1.0f, .anisotropic = 0.5f}, 0.03},
    };
    for (const Case& c : cases) {
        for (double angle_deg : {0.0, 40.0, 75.0}) {
            const Furnace f = furnace(shaded(c.inputs, angle_deg));
            const double noise = 4.0 * f.standard_error + table_error;
            EXPECT_LT(f.returned, 1.0 + noise) << c.name << ", " << angle_deg << " deg";
            EXPECT_GT(f.returned, 1.0 - c.kept_back - noise) << c.name << ", " << angle_deg;
        }
    }
}

TEST(Principled, a_coat_of_no_weight_is_none)
{
    const PrincipledInputs plain{.base_color = blue};
    const PrincipledInputs bare{.base_color = blue,
                                .coat_weight = 0.0f,
                                .coat_roughness = 0.4f,
                                .coat_tint = Color3f(0.0f),
                                .sheen_weight = 0.0f,
                                .sheen_tint = Color3f(5.0f)};
    const V3f wi = direction_at(50.0, 130.0);
    EXPECT_EQ(shaded(bare).evaluate(wi).value, shaded(plain).evaluate(wi).value);
}

TEST(Principled, the_coats_tint_is_met_once_along_the_refracted_view)
{
    // Seen at 60 degrees through index 1.5, the way through the coat is 1 / cos(35.26 deg) long.
    const PrincipledInputs clear{.specular_ior_level = 0.0f, .coat_weight = 1.0f};
    PrincipledInputs tinted = clear;
    tinted.coat_tint = blue;
    const V3f away_from_the_mirror = direction_at(10.0, 0.0);
    const Color3f ratio = shaded(tinted, 60.0).evaluate(away_from_the_mirror).value /
                          shaded(clear, 60.0).evaluate(away_from_the_mirror).value;
    const float depth = 1.0f / std::cos(std::asin(std::sin(float(pi) / 3.0f) / 1.5f));
    EXPECT_NEAR(ratio.x, std::pow(blue.x, depth), 1e-4f);
    EXPECT_NEAR(ratio.z, std::pow(blue.z, depth), 1e-4f);
}

TEST(Principled, the_glow_lies_below_sheen_and_coat)
{
    const PrincipledInputs bare{.emission_strength = 2.0f};
    PrincipledInputs coated = bare;
    coated.coat_weight = 1.0f;
    coated.coat_tint = blue;
    const double angle_deg = 0.0;
    EXPECT_EQ(principled_emission(bare, seen_at(angle_deg)), Color3f(2.0f));
    const Color3f seen = principled_emission(coated, seen_at(angle_deg));
    EXPECT_NEAR(seen.x, 2.0f * 0.96f * blue.x, 1e-4f);
    EXPECT_NEAR(seen.z, 2.0f * 0.96f * blue.z, 1e-4f);
}

TEST(Principled, nonsense_inputs_give_finite_light)
{
    for (float bad : {NAN, INFINITY, -INFINITY, -3.0f, 1e30f, 0.0f}) {
        for (float share : {0.0f, 0.5f}) {
            const PrincipledInputs m{.base_color = Color3f(bad),
                                     .metallic = share == 0.0f ? bad : 0.0f,
                                     .roughness = bad,
                                     .ior = bad,
                                     .alpha = 0.5f,
                                     .normal = V3f(bad),
                                     .diffuse_roughness = bad,
                                     .specular_ior_level = bad,
                                     .specular_tint = Color3f(bad),
                                     .anisotropic = bad,
                                     .anisotropic_rotation = share == 0.0f ? bad : 0.0f,
                                     .tangent = V3f(bad),
                                     .transmission_weight = share,
                                     .coat_weight = bad,
                                     .coat_roughness = bad,
                                     .coat_ior = bad,
                                     .coat_tint = Color3f(bad),
                                     .coat_normal = V3f(bad),
                                     .sheen_weight = bad,
                                     .sheen_roughness = bad,
                                     .sheen_tint = Color3f(bad),
                                     .emission_color = Color3f(bad),
                                     .emission_strength = bad,
                                     .thin_film_thickness_nm = share == 0.0f ? 0.0f : bad,
                                     .thin_film_ior = bad};
            for (double angle_deg : {0.0, 60.0, 89.9999}) {
                const Bsdf bsdf = shaded(m, angle_deg);
                EXPECT_TRUE(test::is_finite(principled_emission(m, seen_at(angle_deg)))) << bad;
                EXPECT_TRUE(test::is_finite(bsdf.albedo())) << bad << " " << share;
                for (float u : {0.0f, 0.3f, 0.6f, 0.99999f}) {
                    const auto s = bsdf.sample(u, {u, 1.0f - u * 0.999f});
                    if (s) {
                        EXPECT_TRUE(test::is_finite(s->weight)) << bad << " at " << angle_deg;
                        EXPECT_TRUE(std::isfinite(s->pdf)) << bad << " at " << angle_deg;
                        EXPECT_NEAR(s->wi.length(), 1.0f, 1e-4f) << bad << " at " << angle_deg;
                    }
                }
                const BsdfValue f = bsdf.evaluate(direction_at(angle_deg, 180.0));
                EXPECT_TRUE(test::is_finite(f.value) && std::isfinite(f.pdf)) << bad;
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
