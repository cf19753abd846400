// Graphs compiled to programs: what is left of them, when it is evaluated, and what it comes to.

#include "shading/program.h"

#include "made_up_hit.h"
#include "scattering.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace eye_render {
namespace {

using test::direction_at;
using test::GraphTrial;
using test::MadeUpHit;
using test::up;

const ShadingPoint point{.wo = direction_at(30.0), .ng = up, .ns = up};
const PathState path;

Color3f emission(const ShaderProgram& program, const MadeUpHit& hit = {})
{
    return program.shade({.point = point, .attributes = hit, .path = path}).emission;
}

// A shining node of this strength.
std::size_t add_emission(GraphTrial& trial, float strength)
{
    const std::size_t node = trial.add("EMISSION");
    trial.graph.set(node, "Color", V3f(1.0f));
    trial.graph.set(node, "Strength", V3f(strength));
    return node;
}

std::size_t add_mix(GraphTrial& trial, float factor, std::size_t first, std::size_t second)
{
    const std::size_t mix = trial.add("MIX_SHADER");
    trial.graph.set(mix, "Fac", V3f(factor));
    const auto link = [&](const char* input, std::size_t node) {
        trial.graph.link(mix, input, {.node = node});
    };
    link("Shader", first);
    link("Shader_001", second);
    return mix;
}

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

TEST(Program, mix_factors_of_zero_and_one_drop_a_shader_with_all_it_reads)
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

TEST(Program, nested_mixes_multiply_and_sums_add)
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

TEST(Program, factors_that_vary_multiply_too_and_stay_between_0_and_1)
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

TEST(Program, shader_that_is_not_linked_is_nothing)
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

// What refuses says so.
std::string refusal(const std::function<void(GraphTrial&)>& build)
{
    GraphTrial trial;
    try {
        build(trial);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Program, links_in_a_circle_are_refused_with_a_nodes_name)
{
    EXPECT_EQ(refusal([](GraphTrial& trial) {
                  const std::size_t light = add_emission(trial, 1.0f);
                  const std::size_t first = trial.add("MATH");
                  const std::size_t second = trial.add("MATH");
                  trial.link(first, "Value", second, "Value");
                  trial.link(second, "Value", first, "Value");
                  trial.link(light, "Strength", first, "Value");
                  static_cast<void>(trial.surface(light, "Emission"));
              }),
              "the links of node 1 (MATH) run in a circle");
    EXPECT_EQ(refusal([](GraphTrial& trial) {
                  const std::size_t mix = trial.add("MIX_SHADER");
                  trial.link(mix, "Shader", mix, "Shader");
                  static_cast<void>(trial.surface(mix, "Shader"));
              }),
              "the links of node 0 (MIX_SHADER) run in a circle");
}

TEST(Program, shader_where_a_value_is_asked_for_is_refused)
{
    EXPECT_EQ(refusal([](GraphTrial& trial) {
                  const std::size_t light = add_emission(trial, 1.0f);
                  trial.link(light, "Color", trial.add("BSDF_DIFFUSE"), "BSDF");
                  static_cast<void>(trial.surface(light, "Emission"));
              }),
              "BSDF_DIFFUSE is a shader; expected a value");
}

TEST(Program, more_lobes_than_a_mixture_holds_are_refused)
{
    const auto added = [](GraphTrial& trial, std::size_t first, std::size_t second) {
        const std::size_t sum = trial.add("ADD_SHADER");
        trial.graph.link(sum, "Shader", {.node = first});
        trial.graph.link(sum, "Shader_001", {.node = second});
        return sum;
    };
    // Two chains, as one would be nested too deep.
    const auto refused = [&](int lobes) {
        return refusal([&](GraphTrial& trial) {
            std::array<std::size_t, 2> chains{trial.add("BSDF_DIFFUSE"),
                                              trial.add("BSDF_DIFFUSE")};
            for (int i = 2; i < lobes; ++i) {
                std::size_t& chain = chains[static_cast<std::size_t>(i % 2)];
                chain = added(trial, chain, trial.add("BSDF_DIFFUSE"));
            }
            static_cast<void>(trial.surface(added(trial, chains[0], chains[1]), "Shader"));
        });
    };
    EXPECT_EQ(refused(Bsdf::capacity), "");
    EXPECT_EQ(refused(Bsdf::capacity + 1), "a mix of shaders has 65 lobes; expected 0 to 64");
}

// Every level doubles the ways to the leaf: refused before they are all gone.
TEST(Program, tree_that_doubles_at_every_level_is_refused_soon)
{
    const auto doubled = [](const char* closure, const char* output) {
        return refusal([&](GraphTrial& trial) {
            std::size_t sum = trial.add(closure);
            std::string_view socket = output;
            for (int i = 0; i < 40; ++i) {
                const std::size_t more = trial.add("ADD_SHADER");
                trial.link(more, "Shader", sum, socket);
                trial.link(more, "Shader_001", sum, socket);
                sum = more;
                socket = "Shader";
            }
            static_cast<void>(trial.surface(sum, "Shader"));
        });
    };
    EXPECT_NE(doubled("BSDF_DIFFUSE", "BSDF"), "");
    EXPECT_NE(doubled("EMISSION", "Emission"), "");
}

TEST(Program, values_convert_as_in_blender)
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
    EXPECT_FLOAT_EQ(strength_of("ATTRIBUTE", "Color", hit), 0.2126f) << "a colour's luminance";
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

TEST(Program, constant_values_convert_as_those_of_a_hit)
{
    GraphTrial trial;
    const std::size_t red = trial.add("RGB", {{"value", std::vector<float>{1.0f, 0.0f, 0.0f}}});
    const std::size_t light = add_emission(trial, 0.0f);
    trial.link(light, "Strength", red, "Color");
    const ShaderProgram program = trial.surface(light, "Emission");
    EXPECT_EQ(program.step_count(), 0u);
    EXPECT_FLOAT_EQ(emission(program).x, 0.2126f);
}

TEST(Program, colour_that_is_linked_to_the_surface_shines)
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
    constexpr int nodes = 300;
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

TEST(Program, holdouts_share_is_that_of_the_mix)
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
