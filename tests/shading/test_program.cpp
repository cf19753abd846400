// Graphs compiled to programs: what is left of them, and when it is evaluated.

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
using test::up;

TEST(Program, constants_are_computed_once_and_for_all)
{
    GraphTrial trial;
    const std::size_t sum = trial.add("MATH", {{"operation", "ADD"}});
    trial.graph.set(sum, "Value", V3f(1.0f));
    trial.graph.set(sum, "Value_001", V3f(2.0f));
    const std::size_t product = trial.add("MATH", {{"operation", "MULTIPLY"}});
    trial.link(product, "Value", sum, "Value");
    trial.graph.set(product, "Value_001", V3f(4.0f));
    const std::size_t light = add_emission(trial, 0.0f);
    trial.link(light, "Strength", product, "Value");
    const ShaderProgram program = trial.surface(light, "Emission");
    EXPECT_EQ(program.step_count(), 0u);
    EXPECT_EQ(program.constant_emission(), Color3f(12.0f));
    EXPECT_EQ(emission(program), Color3f(12.0f));
}

TEST(Program, what_no_output_depends_on_is_not_compiled)
{
    GraphTrial trial;
    const std::size_t unread = trial.add("UVMAP", {{"uv_map", "unread"}});
    const std::size_t unread_picture = trial.add("TEX_IMAGE", {{"texture", 0.0}});
    trial.link(unread_picture, "Vector", unread, "UV");
    const ShaderProgram program = trial.surface(add_emission(trial, 1.0f), "Emission");
    EXPECT_EQ(program.step_count(), 0u);
    EXPECT_TRUE(trial.resources.uv_layers.empty());
    EXPECT_TRUE(trial.resources.textures.empty());
}

TEST(Program, node_that_two_inputs_read_is_evaluated_once_a_hit)
{
    GraphTrial trial;
    const std::size_t picture = trial.add("TEX_IMAGE", {{"texture", 0.0}});
    const std::size_t light = trial.add("EMISSION");
    trial.link(light, "Color", picture, "Color");
    trial.link(light, "Strength", picture, "Alpha");
    const ShaderProgram program = trial.surface(light, "Emission");
    EXPECT_EQ(program.step_count(), 1u);
    MadeUpHit hit;
    hit.texel = Color4f(0.5f, 0.25f, 0.125f, 4.0f);
    EXPECT_EQ(emission(program, hit), Color3f(2.0f, 1.0f, 0.5f));
    EXPECT_EQ(hit.questions, 2) << "its place and its texel";
    EXPECT_EQ(emission(program, hit), Color3f(2.0f, 1.0f, 0.5f));
    EXPECT_EQ(hit.questions, 4) << "and again at the next hit";
}

TEST(Program, node_is_evaluated_only_where_it_is_needed)
{
    // The picture is mixed in by the attribute: where that is 0 nobody looks at it.
    GraphTrial trial;
    const std::size_t picture = trial.add("TEX_IMAGE", {{"texture", 0.0}});
    const std::size_t layer = trial.add("ATTRIBUTE", {{"attribute_name", "a"}});
    const std::size_t pictured = add_emission(trial, 1.0f);
    trial.link(pictured, "Color", picture, "Color");
    const std::size_t mix = add_mix(trial, 0.0f, add_emission(trial, 8.0f), pictured);
    trial.link(mix, "Fac", layer, "Fac");
    const ShaderProgram program = trial.surface(mix, "Shader");
    EXPECT_EQ(program.leaf_count(), 2u);
    MadeUpHit hit;
    hit.layer.value = Color4f(0.0f);
    EXPECT_EQ(emission(program, hit), Color3f(8.0f));
    EXPECT_EQ(hit.questions, 1) << "the attribute";
    hit.layer.value = Color4f(1.0f);
    hit.texel = Color4f(0.5f);
    EXPECT_EQ(emission(program, hit), Color3f(0.5f));
    EXPECT_EQ(hit.questions, 4) << "the attribute, the place and the texel";
}

TEST(Program, inputs_that_nothing_is_linked_to_read_the_hit)
{
    // A picture lies by the mesh's UV layer, a surrounding one by the place.
    GraphTrial trial;
    const std::size_t flat = trial.add("TEX_IMAGE", {{"texture", 1.0}});
    const ShaderProgram program = trial.surface(flat, "Color");
    EXPECT_EQ(trial.resources.uv_layers, std::vector<std::string>{""});
    EXPECT_EQ(trial.resources.textures, std::vector<int>{1});
    MadeUpHit hit;
    hit.uv_value = V2f(0.25f, 0.75f);
    hit.picture = [](int texture, const V2f& uv) {
        return Color4f(uv.x, uv.y, static_cast<float>(texture), 1.0f);
    };
    EXPECT_EQ(emission(program, hit), Color3f(0.25f, 0.75f, 1.0f));
}

TEST(Program, program_larger_than_usual_is_evaluated_all_the_same)
{
    constexpr int nodes = 600;
    GraphTrial trial;
    std::size_t sum = trial.add("ATTRIBUTE", {{"attribute_name", "a"}});
    std::string_view output = "Fac";
    for (int i = 0; i < nodes; ++i) {
        const std::size_t more = trial.add("MATH", {{"operation", "ADD"}});
        trial.link(more, "Value", sum, output);
        trial.graph.set(more, "Value_001", V3f(1.0f));
        sum = more;
        output = "Value";
    }
    const std::size_t light = add_emission(trial, 0.0f);
    trial.link(light, "Strength", sum, "Value");
    const ShaderProgram program = trial.surface(light, "Emission");
    EXPECT_EQ(program.step_count(), std::size_t{nodes + 1});
    MadeUpHit hit;
    hit.layer.value = Color4f(0.5f);
    EXPECT_EQ(emission(program, hit), Color3f(nodes + 0.5f));
}

// The normal that a smooth mirror has.
V3f mirror_normal(const ShaderProgram& program, const ShadingPoint& at, const MadeUpHit& hit)
{
    const auto s = program.shade({.point = at, .attributes = hit, .path = path})
                       .bsdf.sample(0.5f, {0.5f, 0.5f});
    return s ? (s->wi + at.wo).normalized() : V3f(0.0f);
}

TEST(Program, displacement_bends_the_normal_of_all_its_shaders)
{
    // The displacement is the place's own vector: along the normal it rises by p_z, which the
    // tilted surface has as a slope.
    GraphTrial trial;
    const std::size_t mirror = trial.add("BSDF_GLOSSY");
    trial.graph.set(mirror, "Roughness", V3f(0.0f));
    const std::size_t place = trial.add("TEX_COORD");
    const std::size_t displacement = trial.add("DISPLACEMENT", {{"space", "WORLD"}});
    trial.link(displacement, "Height", place, "Generated");
    const ShaderProgram program(trial.graph, trial.graph.output(mirror, "BSDF"),
                                trial.graph.output(displacement, "Displacement"), trial.resources);
    const ShadingPoint seen{.wo = up, .ng = up, .ns = up, .footprint = 0.01f};
    // The mean of the coordinates rises by a third along x and y: normal (-1, -1, 3).
    EXPECT_LT((mirror_normal(program, seen, {}) - V3f(-1, -1, 3).normalized()).length(), 1e-4f);
}

TEST(Program, displacement_is_the_same_for_light_sampling_and_for_shadows)
{
    GraphTrial trial;
    const std::size_t facing = trial.add("LAYER_WEIGHT");
    const std::size_t light = add_emission(trial, 0.0f);
    trial.link(light, "Strength", facing, "Facing");
    const std::size_t clear = trial.add("BSDF_TRANSPARENT");
    trial.link(clear, "Color", facing, "Facing");
    const std::size_t both = trial.add("ADD_SHADER");
    trial.graph.link(both, "Shader", {.node = light});
    trial.graph.link(both, "Shader_001", {.node = clear});
    const std::size_t place = trial.add("TEX_COORD");
    const std::size_t displacement = trial.add("DISPLACEMENT", {{"space", "WORLD"}});
    trial.link(displacement, "Height", place, "Generated");
    const ShaderProgram program(trial.graph, trial.graph.output(both, "Shader"),
                                trial.graph.output(displacement, "Displacement"), trial.resources);
    const ShadingPoint seen{.wo = up, .ng = up, .ns = up, .footprint = 0.01f};
    const MadeUpHit at;
    const Hit hit{.point = seen, .attributes = at, .path = path};
    const ShadedPoint shaded = program.shade(hit);
    EXPECT_GT(shaded.emission.x, 0.05f);
    EXPECT_EQ(program.emission(hit), shaded.emission);
    EXPECT_EQ(program.straight_transmittance(hit), shaded.bsdf.straight());
}

TEST(Program, constant_displacement_bends_nothing_and_costs_nothing)
{
    GraphTrial trial;
    const std::size_t lift = trial.add("COMBXYZ");
    trial.graph.set(lift, "Z", V3f(0.3f));
    const std::size_t light = add_emission(trial, 1.0f);
    const ShaderProgram program(trial.graph, trial.graph.output(light, "Emission"),
                                trial.graph.output(lift, "Vector"), trial.resources);
    EXPECT_EQ(program.step_count(), 0u);
    const MadeUpHit hit;
    EXPECT_EQ(emission(program, hit), Color3f(1.0f));
    EXPECT_EQ(hit.questions, 0);
}

}  // namespace
}  // namespace eye_render
