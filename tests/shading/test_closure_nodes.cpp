// Closures as nodes: what they say of themselves before any hit, and what they do at one.

#include "closure_trial.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::ClosureTrial;
using test::direction_at;
using test::up;

const Color3f blue(0.1f, 0.3f, 0.9f);

TEST(ClosureNodes, a_plain_principled_is_opaque_dark_and_has_two_lobes)
{
    const ClosureFacts facts = ClosureTrial("BSDF_PRINCIPLED").facts();
    EXPECT_FALSE(facts.may_be_transparent);
    EXPECT_FALSE(facts.may_emit);
    EXPECT_EQ(facts.lobes, 2);
}

TEST(ClosureNodes, principled_counts_a_lobe_for_every_layer_it_may_have)
{
    const ClosureFacts facts = ClosureTrial("BSDF_PRINCIPLED")
                                   .set("Alpha", 0.5f)
                                   .set("Metallic", 0.1f)
                                   .set("Transmission Weight", 0.1f)
                                   .set("Coat Weight", 0.1f)
                                   .set("Sheen Weight", 0.1f)
                                   .set("Emission Strength", 1.0f)
                                   .facts();
    EXPECT_TRUE(facts.may_be_transparent);
    EXPECT_TRUE(facts.may_emit);
    EXPECT_EQ(facts.lobes, 7);
}

TEST(ClosureNodes, a_weight_dims_all_that_a_closure_does)
{
    for (const NodeType& type : closure_nodes()) {
        const ClosureTrial closure(type.name);
        const ShadedPoint whole = closure.shade(test::seen_at(40.0));
        const ShadedPoint half = closure.shade(test::seen_at(40.0), 0.5f);
        EXPECT_LT((half.bsdf.albedo() * 2.0f - whole.bsdf.albedo()).length(), 1e-5f) << type.name;
        EXPECT_LT((half.emission * 2.0f - whole.emission).length(), 1e-5f) << type.name;
        for (const V3f& wi : {direction_at(35.0, 170.0), direction_at(140.0, 170.0)}) {
            const Color3f value = whole.bsdf.evaluate(wi).value;
            EXPECT_LE((half.bsdf.evaluate(wi).value * 2.0f - value).length(),
                      1e-4f * value.length())
                << type.name;
        }
        EXPECT_EQ(half.holdout * 2.0f, whole.holdout) << type.name;
    }
}

TEST(ClosureNodes, transparent_passes_its_colour_straight)
{
    const ClosureTrial closure = ClosureTrial("BSDF_TRANSPARENT").set("Color", V3f(blue));
    EXPECT_TRUE(closure.facts().may_be_transparent);
    EXPECT_EQ(closure.straight_transmittance(), blue);
    EXPECT_FALSE(ClosureTrial("BSDF_TRANSPARENT").set("Color", 0.0f).facts().may_be_transparent);
}

TEST(ClosureNodes, emission_is_colour_times_strength)
{
    for (const char* name : {"EMISSION", "BACKGROUND"}) {
        const ClosureTrial closure =
            ClosureTrial(name).set("Color", V3f(blue)).set("Strength", 3.0f);
        EXPECT_EQ(closure.emission(20.0), blue * 3.0f) << name;
        EXPECT_EQ(closure.shade(20.0).emission, blue * 3.0f) << name;
        EXPECT_TRUE(closure.shade(20.0).bsdf.is_delta_only()) << name;
        EXPECT_FALSE(ClosureTrial(name).set("Strength", 0.0f).facts().may_emit) << name;
    }
}

TEST(ClosureNodes, principled_tells_light_sampling_what_it_shows)
{
    const ClosureTrial closure = ClosureTrial("BSDF_PRINCIPLED")
                                     .set("Emission Color", V3f(blue))
                                     .set("Emission Strength", 2.0f)
                                     .set("Coat Weight", 1.0f)
                                     .set("Sheen Weight", 0.5f)
                                     .set("Alpha", 0.5f);
    for (double angle_deg : {0.0, 60.0}) {
        EXPECT_EQ(closure.emission(angle_deg), closure.shade(angle_deg).emission) << angle_deg;
    }
}

TEST(ClosureNodes, every_option_of_blender_is_taken_and_others_are_refused)
{
    const auto with = [](const char* type, const char* option, const char* value) {
        return ClosureTrial(type, NodeOptions({{option, std::string(value)}}));
    };
    for (const char* distribution : {"BECKMANN", "GGX", "ASHIKHMIN_SHIRLEY", "MULTI_GGX"}) {
        EXPECT_NO_THROW(with("BSDF_GLOSSY", "distribution", distribution));
    }
    EXPECT_THROW(with("BSDF_GLOSSY", "distribution", "PHONG"), std::invalid_argument);
    EXPECT_THROW(with("BSDF_SHEEN", "distribution", "GGX"), std::invalid_argument);
    EXPECT_THROW(with("BSDF_TOON", "component", "Diffuse"), std::invalid_argument);
    EXPECT_THROW(with("BSDF_METALLIC", "fresnel_type", "SCHLICK"), std::invalid_argument);
}

TEST(ClosureNodes, hair_gives_back_no_more_light_than_it_got)
{
    for (const double angle_deg : {0.0, 45.0, 80.0}) {
        const ClosureTrial white = ClosureTrial("BSDF_HAIR").set("Color", V3f(1.0f));
        const double albedo = test::integrate(white.shade(angle_deg).bsdf, 256).value.x;
        EXPECT_LT(albedo, 1.01) << angle_deg;
        EXPECT_GT(albedo, 0.6) << angle_deg;
    }
}

TEST(ClosureNodes, pigment_darkens_hair_and_its_kind_colours_it)
{
    const auto hair = [](float melanin, float redness) {
        return ClosureTrial("BSDF_HAIR_PRINCIPLED",
                            NodeOptions({{"parametrization", std::string("MELANIN")}}))
            .set("Melanin", melanin)
            .set("Melanin Redness", redness)
            .shade(30.0)
            .bsdf.albedo();
    };
    EXPECT_NEAR(hair(0.0f, 0.0f).x, 1.0f, 0.02f);  // without it all light leaves
    EXPECT_LT(hair(0.5f, 0.5f).x, hair(0.2f, 0.5f).x);
    const auto red_to_green = [](const Color3f& c) { return c.x / c.y; };
    EXPECT_GT(red_to_green(hair(0.3f, 1.0f)), red_to_green(hair(0.3f, 0.0f)));
}

TEST(ClosureNodes, glass_is_thin_to_the_viewer_inside)
{
    // Beyond the critical angle of 41.8 degrees nothing passes.
    ShadingPoint point = test::seen_at(50.0);
    point.backfacing = true;
    const auto s = ClosureTrial("BSDF_GLASS").shade(point).bsdf.sample(0.999f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_FALSE(s->is_transmitted);
}

}  // namespace
}  // namespace eye_render
