// Values in programs, where a socket of one kind is linked to one of another.

#include "program_trial.h"
#include "shading/functions/spectral_colors.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

constexpr float digits = 1e-4f;  // of luminances as standards print them

using test::add_emission;
using test::emission;
using test::GraphTrial;
using test::MadeUpHit;

TEST(ProgramConversions, values_convert_as_in_blender)
{
    const auto strength_of = [](const char* node, const char* output, const MadeUpHit& hit) {
        GraphTrial trial;
        const std::size_t source = trial.add(node);
        const std::size_t light = add_emission(trial, 0.0f);
        trial.link(light, "Strength", source, output);
        return emission(trial.surface(light, "Emission"), hit).x;
    };
    MadeUpHit hit;
    hit.layer.value = Color4f(1.0f, 0.0f, 0.0f, 1.0f);
    EXPECT_NEAR(strength_of("ATTRIBUTE", "Color", hit), 0.2126f, digits) << "a colour's luminance";
    EXPECT_FLOAT_EQ(strength_of("ATTRIBUTE", "Vector", hit), 1.0f / 3.0f) << "a vector's mean";
    hit.p_generated = V3f(0.1f, 0.2f, 0.6f);
    EXPECT_FLOAT_EQ(strength_of("TEX_COORD", "Generated", hit), 0.3f);

    GraphTrial trial;
    const std::size_t light = trial.add("EMISSION");
    trial.link(light, "Color", trial.add("ATTRIBUTE", {{"attribute_name", "a"}}), "Alpha");
    hit.layer.value = Color4f(0.0f, 0.0f, 0.0f, 0.75f);
    EXPECT_EQ(emission(trial.surface(light, "Emission"), hit), Color3f(0.75f))
        << "a number fills a colour";
}

TEST(ProgramConversions, constant_values_convert_as_those_of_a_hit)
{
    GraphTrial trial;
    const std::size_t red = trial.add("RGB", {{"value", std::vector<float>{1.0f, 0.0f, 0.0f}}});
    const std::size_t light = add_emission(trial, 0.0f);
    trial.link(light, "Strength", red, "Color");
    const ShaderProgram program = trial.surface(light, "Emission");
    EXPECT_EQ(program.step_count(), 0u);
    EXPECT_NEAR(emission(program).x, 0.2126f, digits);
}

// Emission of a shader whose Color is linked to the node's output.
Color3f shown(WorkingSpace space,
              const char* node,
              const char* output,
              std::map<std::string, NodeOptions::Value> options = {})
{
    GraphTrial trial;
    trial.resources.space = space;
    const std::size_t source = trial.add(node, std::move(options));
    const std::size_t light = add_emission(trial, 1.0f);
    trial.link(light, "Color", source, output);
    return emission(trial.surface(light, "Emission"));
}

TEST(ProgramConversions, lights_physics_is_seen_in_the_working_space)
{
    constexpr float rounding = 1e-4f;
    const auto difference = [](const char* node) {
        const Color3f in_rec709 = shown(WorkingSpace::Rec709, node, "Color");
        return (shown(WorkingSpace::Rec2020, node, "Color") -
                rgb_from_rec709(in_rec709, WorkingSpace::Rec2020))
            .length();
    };
    // At the top of the default sky nothing is out of either gamut.
    EXPECT_LE(difference("TEX_SKY"), rounding);
    EXPECT_NE(shown(WorkingSpace::Rec2020, "TEX_SKY", "Color"),
              shown(WorkingSpace::Rec709, "TEX_SKY", "Color"));
    // 1500 K, of which Rec. 709 has too little blue.
    EXPECT_LE((shown(WorkingSpace::AcesCg, "BLACKBODY", "Color") -
               rgb_of_blackbody(1500.0f, WorkingSpace::AcesCg))
                  .length(),
              rounding);
}

TEST(ProgramConversions, luminance_is_of_the_working_space)
{
    for (const WorkingSpace space : {WorkingSpace::Rec709, WorkingSpace::AcesCg}) {
        const float red = luminance_weights(space).x;
        GraphTrial trial;
        trial.resources.space = space;
        const std::size_t layer = trial.add("ATTRIBUTE", {{"attribute_name", "a"}});
        const std::size_t grey = trial.add("RGBTOBW");
        trial.link(grey, "Color", layer, "Color");
        MadeUpHit hit;
        hit.layer.value = Color4f(1.0f, 0.0f, 0.0f, 1.0f);
        const std::size_t light = add_emission(trial, 0.0f);
        trial.link(light, "Color", grey, "Val");
        trial.link(light, "Strength", layer, "Color");
        const Color3f squared = emission(trial.surface(light, "Emission"), hit);
        EXPECT_FLOAT_EQ(squared.x, red * red);
    }
}

TEST(ProgramConversions, colour_that_is_linked_to_the_surface_shines)
{
    GraphTrial trial;
    const std::size_t layer = trial.add("ATTRIBUTE", {{"attribute_name", "a"}});
    const ShaderProgram program = trial.surface(layer, "Color");
    EXPECT_TRUE(program.may_emit());
    EXPECT_EQ(program.leaf_count(), 1u);
    MadeUpHit hit;
    hit.layer.value = Color4f(0.5f, 2.0f, 0.25f, 1.0f);
    EXPECT_EQ(emission(program, hit), Color3f(0.5f, 2.0f, 0.25f));
}

}  // namespace
}  // namespace eye_render
