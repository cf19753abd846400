// Graphs of which no program can be made.

#include "program_trial.h"

#include <gtest/gtest.h>

#include <array>
#include <functional>

namespace eye_render {
namespace {

using test::add_emission;
using test::GraphTrial;

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

TEST(ProgramRefusals, links_in_a_circle_are_refused_with_a_nodes_name)
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

TEST(ProgramRefusals, shader_where_a_value_is_asked_for_is_refused)
{
    EXPECT_EQ(refusal([](GraphTrial& trial) {
                  const std::size_t light = add_emission(trial, 1.0f);
                  trial.link(light, "Color", trial.add("BSDF_DIFFUSE"), "BSDF");
                  static_cast<void>(trial.surface(light, "Emission"));
              }),
              "BSDF_DIFFUSE is a shader; expected a value");
}

TEST(ProgramRefusals, more_lobes_than_a_mixture_holds_are_refused)
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
TEST(ProgramRefusals, tree_that_doubles_at_every_level_is_refused_soon)
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

}  // namespace
}  // namespace eye_render
