// Materials of one closure, and what a material remembers of the graph that it was made from.

#include "shading/material.h"

#include "made_up_hit.h"
#include "options_of.h"
#include "scattering.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::AnyResources;
using test::direction_at;
using test::GraphTrial;
using test::MadeUpHit;
using test::up;

const Color3f orange(0.9f, 0.5f, 0.2f);
const ShadingPoint point{.wo = direction_at(30.0), .ng = up, .ns = up};
const PathState path;

ShadedPoint shaded(const Material& material,
                   const ShadingPoint& at = point,
                   const HitAttributes& attributes = MadeUpHit())
{
    return material.surface.shade({.point = at, .attributes = attributes, .path = path});
}

Color3f passing(const Material& material)
{
    const MadeUpHit hit;
    return material.surface.straight_transmittance(
        {.point = point, .attributes = hit, .path = path});
}

TEST(Material, diffuse_is_lambert_of_its_colour)
{
    const Material m = plain_material("BSDF_DIFFUSE", {{"Color", orange}});
    const V3f wi = direction_at(50.0, 40.0);
    EXPECT_LT((shaded(m).bsdf.evaluate(wi).value - orange * (wi.z / float(pi))).length(), 1e-6f);
}

TEST(Material, glossy_mirrors_its_colour_at_every_angle)
{
    const Material m =
        plain_material("BSDF_GLOSSY", {{"Color", orange}, {"Roughness", V3f(0.0f)}});
    for (double angle_deg : {0.0, 89.0}) {
        const ShadingPoint seen{.wo = direction_at(angle_deg), .ng = up, .ns = up};
        const auto s = shaded(m, seen).bsdf.sample(0.5f, {0.5f, 0.5f});
        ASSERT_TRUE(s);
        EXPECT_LT((s->weight - orange).length(), 1e-5f) << angle_deg;
    }
}

TEST(Material, glass_tints_what_it_reflects_and_what_passes)
{
    const Material m = plain_material("BSDF_GLASS", {{"Color", orange}, {"Roughness", V3f(0.0f)}});
    const Bsdf bsdf = shaded(m).bsdf;
    for (float u : {0.0f, 0.999f}) {
        const auto s = bsdf.sample(u, {0.5f, 0.5f});
        ASSERT_TRUE(s);
        EXPECT_EQ(s->wi.z > 0.0f, u == 0.0f);
        EXPECT_LT((s->weight - orange).length(), 1e-5f) << u;
    }
}

TEST(Material, multiple_scattering_is_a_choice)
{
    const auto returned = [](const char* distribution) {
        const Material m =
            plain_material("BSDF_GLOSSY", {{"Color", V3f(1.0f)}, {"Roughness", V3f(1.0f)}},
                           test::options_of({{"distribution", distribution}}));
        return test::integrate(shaded(m, {.wo = up, .ng = up, .ns = up}).bsdf).value.x;
    };
    EXPECT_NEAR(returned("MULTI_GGX"), 1.0, 0.01);
    EXPECT_NEAR(returned("GGX"), 1.0 - std::log(2.0), 1e-3);
}

TEST(Material, transparent_passes_its_colour_straight)
{
    const Material m = plain_material("BSDF_TRANSPARENT", {{"Color", orange}});
    const auto s = shaded(m).bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_straight);
    EXPECT_LT((s->weight - orange).length(), 1e-6f);
    EXPECT_EQ(passing(m), orange);
    EXPECT_EQ(passing(plain_material("BSDF_GLASS", {})), Color3f(0.0f));
}

TEST(Material, emission_glows_and_scatters_nothing)
{
    const Material m = plain_material("EMISSION", {{"Color", orange}, {"Strength", V3f(10.0f)}});
    const ShadedPoint found = shaded(m);
    EXPECT_LT((found.emission - orange * 10.0f).length(), 1e-5f);
    EXPECT_TRUE(found.bsdf.is_delta_only());
    EXPECT_FALSE(found.bsdf.sample(0.5f, {0.5f, 0.5f}));
    const MadeUpHit hit;
    EXPECT_EQ(m.surface.emission({.point = point, .attributes = hit, .path = path}),
              found.emission);
    EXPECT_EQ(hit.questions, 0);
}

TEST(Material, says_what_it_may_do_before_any_hit)
{
    const auto principled = [](std::initializer_list<std::pair<std::string_view, NodeValue>> in) {
        return plain_material("BSDF_PRINCIPLED", in).surface;
    };
    EXPECT_FALSE(principled({}).may_be_transparent());
    EXPECT_FALSE(principled({}).may_emit());
    EXPECT_TRUE(principled({{"Alpha", V3f(0.99f)}}).may_be_transparent());
    EXPECT_TRUE(principled({{"Emission Strength", V3f(1.0f)}}).may_emit());
    EXPECT_FALSE(
        principled({{"Emission Strength", V3f(1.0f)}, {"Emission Color", V3f(0.0f)}}).may_emit());
    EXPECT_TRUE(plain_material("BSDF_TRANSPARENT", {}).surface.may_be_transparent());
    EXPECT_FALSE(plain_material("BSDF_DIFFUSE", {}).surface.may_be_transparent());
}

TEST(Material, what_is_not_known_before_the_hit_may_be_anything)
{
    GraphTrial trial;
    const std::size_t picture = trial.add("TEX_IMAGE", {{"texture", 0.0}});
    const std::size_t principled = trial.add("BSDF_PRINCIPLED");
    trial.link(principled, "Alpha", picture, "Alpha");
    trial.link(principled, "Emission Strength", picture, "Color");
    const ShaderProgram program = trial.surface(principled, "BSDF");
    EXPECT_TRUE(program.may_be_transparent());
    EXPECT_TRUE(program.may_emit());
    EXPECT_FALSE(program.constant_emission());
}

TEST(Material, remembers_what_it_reads_of_the_scene_once_each)
{
    class Numbering final : public NodeResources {
    public:
        [[nodiscard]] int uv_layer(const std::string& name) override
        {
            return name == "b" ? 2 : 0;
        }
        [[nodiscard]] int attribute(const std::string&) override { return 5; }
        void require_texture(int) override {}
        [[nodiscard]] WorkingSpace working_space() override { return WorkingSpace::Rec709; }
    };
    GraphTrial trial;
    const std::size_t map = trial.add("UVMAP", {{"uv_map", "b"}});
    const std::size_t first = trial.add("TEX_IMAGE", {{"texture", 9.0}});
    const std::size_t second = trial.add("TEX_IMAGE", {{"texture", 3.0}});
    const std::size_t layer = trial.add("ATTRIBUTE", {{"attribute_name", "Col"}});
    const std::size_t unread = trial.add("TEX_IMAGE", {{"texture", 4.0}});
    const std::size_t principled = trial.add("BSDF_PRINCIPLED");
    trial.link(first, "Vector", map, "UV");
    trial.link(principled, "Base Color", first, "Color");
    trial.link(principled, "Roughness", second, "Color");  // lies by the first layer
    trial.link(principled, "Metallic", layer, "Fac");
    static_cast<void>(unread);
    Numbering resources;
    const Material m = make_material(
        "m", trial.graph, {.surface = trial.graph.output(principled, "BSDF")}, resources);
    EXPECT_EQ(m.name, "m");
    EXPECT_EQ(m.uv_layers, (std::vector<int>{0, 2}));
    EXPECT_EQ(m.attributes, std::vector<int>{5});
    EXPECT_EQ(m.textures, (std::vector<int>{3, 9}));
}

TEST(Material, plain_one_has_nowhere_to_look)
{
    EXPECT_THROW(static_cast<void>(plain_material("TEX_IMAGE", {})), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
