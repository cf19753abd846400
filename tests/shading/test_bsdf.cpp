// Mixtures of lobes, and what single lobes promise exactly.

#include "lobe_cases.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::Random;
using test::up;

TEST(Bsdf, a_mixture_of_all_the_lobes_it_holds_loses_none)
{
    Bsdf bsdf(up, up);
    const Color3f share(1.0f / float(Bsdf::capacity));
    for (int i = 0; i < Bsdf::capacity; ++i) {
        bsdf.add(diffuse_lobe(share, up, up), share);
    }
    const Bsdf copy = bsdf;
    for (const Bsdf* one : {static_cast<const Bsdf*>(&bsdf), &copy}) {
        EXPECT_NEAR(one->evaluate(up).value.x, 1.0 / pi, 1e-6);
        EXPECT_NEAR(one->sample(0.999f, {0.2f, 0.3f})->weight.x, 1.0f, 1e-5f);
    }
}

TEST(Bsdf, lambert_returns_exactly_its_colour)
{
    Bsdf bsdf(direction_at(60.0), up);
    const Color3f color(0.9f, 0.5f, 0.2f);
    bsdf.add(diffuse_lobe(color, up, up), color);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::optional<BsdfSample> s = random.sample(bsdf);
        if (s) {
            ASSERT_LT((s->weight - color).length(), 1e-6f);
        }
    }
    EXPECT_NEAR(test::integrate(bsdf).value.x, 0.9, 1e-4);
    EXPECT_EQ(bsdf.albedo(), color);
}

TEST(Bsdf, a_mirror_reflects_and_is_found_by_sampling_alone)
{
    Bsdf bsdf(direction_at(40.0), up);
    bsdf.add(glossy_lobe(Color3f(0.8f), up, 0.0f), Color3f(0.8f));
    EXPECT_TRUE(bsdf.is_delta_only());
    const std::optional<BsdfSample> s = bsdf.sample(0.3f, {0.2f, 0.9f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_delta);
    EXPECT_FALSE(s->is_straight);
    EXPECT_EQ(s->pdf, 0.0f);
    EXPECT_LT((s->wi - direction_at(40.0, 180.0)).length(), 1e-6f);
    EXPECT_LT((s->weight - Color3f(0.8f)).length(), 1e-6f);
    EXPECT_EQ(bsdf.evaluate(s->wi).value, Color3f(0.0f));
}

TEST(Bsdf, smooth_glass_refracts_by_snells_law_both_ways_without_loss)
{
    for (float ior : {1.5f, 1.0f / 1.5f}) {
        const double angle_deg = 30.0;
        Bsdf bsdf(direction_at(angle_deg), up);
        bsdf.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, 0.0f, ior), Color3f(1.0f));
        const double bent_deg = deg_from_rad(std::asin(std::sin(rad_from_deg(angle_deg)) / ior));
        const std::optional<BsdfSample> passed = bsdf.sample(0.999f, {0.5f, 0.5f});
        ASSERT_TRUE(passed);
        EXPECT_LT((passed->wi + direction_at(bent_deg)).length(), 1e-5f) << ior;
        EXPECT_NEAR(passed->weight.x, 1.0f, 1e-6f);
        const std::optional<BsdfSample> reflected = bsdf.sample(0.0f, {0.5f, 0.5f});
        ASSERT_TRUE(reflected);
        EXPECT_LT((reflected->wi - direction_at(angle_deg, 180.0)).length(), 1e-5f);
        EXPECT_NEAR(reflected->weight.x, 1.0f, 1e-6f);
    }
}

TEST(Bsdf, glass_in_glass_of_its_own_index_is_not_there)
{
    const V3f wo = direction_at(70.0, 20.0);
    for (float ior : {1.0f, 1.0002f, 0.9998f}) {
        Bsdf bsdf(wo, up);
        bsdf.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, 0.5f, ior), Color3f(1.0f));
        EXPECT_TRUE(bsdf.is_delta_only());
        const std::optional<BsdfSample> s = bsdf.sample(0.9f, {0.3f, 0.3f});
        ASSERT_TRUE(s);
        EXPECT_LT((s->wi + wo).length(), 2e-3f) << ior;
    }
}

TEST(Bsdf, straight_light_passes_and_is_no_part_of_the_albedo)
{
    const V3f wo = direction_at(70.0, 20.0);
    Bsdf bsdf(wo, up);
    bsdf.add(straight_lobe(Color3f(0.25f)), Color3f(0.25f));
    bsdf.add(diffuse_lobe(Color3f(0.75f), up, up), Color3f(0.75f));
    EXPECT_FALSE(bsdf.is_delta_only());
    EXPECT_EQ(bsdf.albedo(), Color3f(0.75f));
    const std::optional<BsdfSample> s = bsdf.sample(0.2f, {0.3f, 0.3f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_delta && s->is_straight);
    EXPECT_EQ(s->wi, -wo);
    EXPECT_NEAR(s->weight.x, 1.0f, 1e-6f);
    const std::optional<BsdfSample> other = bsdf.sample(0.3f, {0.3f, 0.3f});
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->is_straight);
    EXPECT_NEAR(other->weight.x, 1.0f, 1e-5f);
}

TEST(Bsdf, no_light_where_the_geometry_and_the_shading_normal_disagree)
{
    // Normal turned 60 degrees: below the geometry but above the shading normal, and the reverse.
    const V3f ns = direction_at(60.0);
    const V3f below_geometry = direction_at(110.0);
    const V3f below_shading = direction_at(80.0, 180.0);
    const Color3f white(1.0f);
    for (const Lobe& lobe :
         {diffuse_lobe(white, ns, up), glossy_lobe(white, ns, 0.5f),
          dielectric_lobe(white, ns, 0.5f, 1.5f), glass_lobe(white, white, ns, 0.5f, 1.5f)}) {
        Bsdf bsdf(direction_at(30.0), up);
        bsdf.add(lobe, white);
        for (const V3f& wi : {below_geometry, below_shading}) {
            EXPECT_EQ(bsdf.evaluate(wi).value, Color3f(0.0f)) << int(lobe.kind) << " " << wi;
            EXPECT_EQ(bsdf.evaluate(wi).pdf, 0.0f) << int(lobe.kind) << " " << wi;
        }
    }
}

TEST(Bsdf, a_lobe_without_albedo_is_left_out)
{
    Bsdf bsdf(up, up);
    bsdf.add(diffuse_lobe(Color3f(0.0f), up, up), Color3f(0.0f));
    bsdf.add(diffuse_lobe(Color3f(NAN), up, up), Color3f(NAN));
    EXPECT_TRUE(bsdf.is_delta_only());
    EXPECT_FALSE(bsdf.sample(0.5f, {0.5f, 0.5f}));
    EXPECT_FALSE(Bsdf().sample(0.5f, {0.5f, 0.5f}));
    EXPECT_EQ(Bsdf().evaluate(up).pdf, 0.0f);
}

}  // namespace
}  // namespace eye_render
