// Mixtures of shaders in programs: which share each has.

#include "program_trial.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::add_emission;
using test::add_mix;
using test::emission;
using test::GraphTrial;
using test::MadeUpHit;
using test::path;
using test::point;

TEST(ProgramMixtures, mix_factors_of_zero_and_one_drop_a_shader_with_all_it_reads)
{
    for (const float factor : {0.0f, 1.0f, -3.0f, 7.0f}) {
        GraphTrial trial;
        const std::size_t picture = trial.add("TEX_IMAGE", {{"texture", 0.0}});
        const std::size_t dropped = add_emission(trial, 1.0f);
        trial.link(dropped, "Color", picture, "Color");
        const std::size_t kept = add_emission(trial, 2.0f);
        const std::size_t mix = factor > 0.0f ? add_mix(trial, factor, dropped, kept)
                                              : add_mix(trial, factor, kept, dropped);
        const ShaderProgram program = trial.surface(mix, "Shader");
        EXPECT_EQ(program.leaf_count(), 1u) << factor;
        EXPECT_EQ(program.step_count(), 0u) << factor;
        EXPECT_EQ(program.constant_emission(), Color3f(2.0f)) << factor;
        EXPECT_TRUE(trial.resources.textures.empty()) << factor;
    }
}

TEST(ProgramMixtures, nested_mixes_multiply_and_sums_add)
{
    GraphTrial trial;
    const std::size_t inner =
        add_mix(trial, 0.25f, add_emission(trial, 1.0f), add_emission(trial, 100.0f));
    const std::size_t outer = add_mix(trial, 0.5f, inner, add_emission(trial, 10000.0f));
    const std::size_t sum = trial.add("ADD_SHADER");
    trial.graph.link(sum, "Shader", {.node = outer});
    trial.graph.link(sum, "Shader_001", {.node = outer});
    const ShaderProgram program = trial.surface(sum, "Shader");
    EXPECT_EQ(program.leaf_count(), 6u);
    EXPECT_EQ(emission(program), Color3f(2.0f * (0.5f * (0.75f + 25.0f) + 5000.0f)));
}

TEST(ProgramMixtures, factors_that_vary_multiply_too_and_stay_between_0_and_1)
{
    GraphTrial trial;
    const std::size_t layer = trial.add("ATTRIBUTE", {{"attribute_name", "a"}});
    const std::size_t inner =
        add_mix(trial, 0.0f, add_emission(trial, 1.0f), add_emission(trial, 100.0f));
    const std::size_t outer = add_mix(trial, 0.0f, inner, add_emission(trial, 10000.0f));
    trial.link(inner, "Fac", layer, "Fac");
    trial.link(outer, "Fac", layer, "Alpha");
    const ShaderProgram program = trial.surface(outer, "Shader");
    const auto at = [&](float inner_factor, float outer_factor) {
        MadeUpHit hit;
        hit.layer.value = Color4f(inner_factor, inner_factor, inner_factor, outer_factor);
        return emission(program, hit).x;
    };
    EXPECT_FLOAT_EQ(at(0.25f, 0.5f), 0.5f * (0.75f + 25.0f) + 5000.0f);
    EXPECT_FLOAT_EQ(at(-2.0f, 0.5f), 0.5f + 5000.0f);
    EXPECT_FLOAT_EQ(at(0.25f, 9.0f), 10000.0f);
    EXPECT_FLOAT_EQ(at(NAN, 0.5f), 0.5f + 5000.0f);
}

TEST(ProgramMixtures, shader_that_is_not_linked_is_nothing)
{
    GraphTrial trial;
    const std::size_t mix = trial.add("MIX_SHADER");
    trial.graph.set(mix, "Fac", V3f(0.25f));
    trial.link(mix, "Shader_001", add_emission(trial, 4.0f), "Emission");
    EXPECT_EQ(emission(trial.surface(mix, "Shader")), Color3f(1.0f));
    const ShaderProgram none;
    EXPECT_EQ(emission(none), Color3f(0.0f));
    EXPECT_EQ(none.constant_emission(), Color3f(0.0f));
}

TEST(ProgramMixtures, holdouts_share_is_that_of_the_mix)
{
    GraphTrial trial;
    const std::size_t mix = add_mix(trial, 0.75f, add_emission(trial, 4.0f), trial.add("HOLDOUT"));
    const MadeUpHit hit;
    const ShadedPoint shaded =
        trial.surface(mix, "Shader").shade({.point = point, .attributes = hit, .path = path});
    EXPECT_EQ(shaded.holdout, 0.75f);
    EXPECT_EQ(shaded.emission, Color3f(1.0f));
}

}  // namespace
}  // namespace eye_render
