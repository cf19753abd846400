// Every mistake in a graph is refused where it is made, in words that name it.

#include "shading/node_graph.h"
#include "shading/program.h"

#include "made_up_hit.h"
#include "options_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <set>

namespace eye_render {
namespace {

std::string refusal(const std::function<void(NodeGraph&)>& build)
{
    NodeGraph graph;
    graph.add("EMISSION");
    graph.add("TEX_COORD");
    try {
        build(graph);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(NodeGraph, refuses_what_does_not_exist_and_says_what_does)
{
    EXPECT_EQ(refusal([](NodeGraph& g) { g.add("WOOL"); }), "node kind 'WOOL' is not supported");
    EXPECT_EQ(refusal([](NodeGraph& g) {
                  g.add("FRESNEL", test::options_of({{"samples", 4.0}}));
              }),
              "option 'samples' of FRESNEL does not exist; expected none");
    EXPECT_EQ(refusal([](NodeGraph& g) {
                  g.add("UVMAP", test::options_of({{"layer", "a"}}));
              }),
              "option 'layer' of UVMAP does not exist; expected one of uv_map");
    EXPECT_EQ(refusal([](NodeGraph& g) { g.set(0, "Brightness", V3f(1.0f)); }),
              "input 'Brightness' of EMISSION does not exist; expected one of Color, Strength");
    EXPECT_EQ(refusal([](NodeGraph& g) { static_cast<void>(g.output(0, "Color")); }),
              "output 'Color' of EMISSION does not exist; expected one of Emission");
    EXPECT_EQ(refusal([](NodeGraph& g) { g.link(0, "Hue", g.output(1, "UV")); }),
              "input 'Hue' of EMISSION does not exist; expected one of Color, Strength");
    EXPECT_EQ(refusal([](NodeGraph& g) { g.set(2, "Color", V3f(1.0f)); }),
              "node 2 does not exist; the graph has 2");
    EXPECT_EQ(refusal([](NodeGraph& g) { g.link(0, "Color", {.node = 7}); }),
              "node 7 does not exist; the graph has 2");
}

TEST(NodeGraph, refuses_values_that_an_option_cannot_have_where_they_are_said)
{
    EXPECT_EQ(refusal([](NodeGraph& g) {
                  g.add("TEX_VORONOI", test::options_of({{"feature", "F3"}}));
              }).substr(0, 18),
              "feature is F3; exp");
    EXPECT_EQ(refusal([](NodeGraph& g) {
                  g.add("BSDF_TOON", test::options_of({{"component", "MATTE"}}));
              }),
              "component is MATTE; expected one of DIFFUSE, GLOSSY");
    // Which textures there are is the scene's to know.
    EXPECT_EQ(refusal([](NodeGraph& g) {
                  g.add("TEX_IMAGE", test::options_of({{"texture", 7.0}}));
              }),
              "");
}

TEST(NodeGraph, refuses_numbers_that_are_not_finite)
{
    for (const float broken : {NAN, INFINITY, -INFINITY}) {
        EXPECT_EQ(refusal([&](NodeGraph& g) { g.set(0, "Color", V3f(0.0f, broken, 0.0f)); }),
                  "input 'Color' of EMISSION is not finite; expected finite numbers");
    }
    // Each is finite, if not their sum.
    EXPECT_EQ(refusal([](NodeGraph& g) { g.set(0, "Color", V3f(3e38f)); }), "");
}

TEST(NodeGraph, refuses_an_output_that_the_node_does_not_have)
{
    EXPECT_EQ(refusal([](NodeGraph& g) { g.link(0, "Color", {.node = 1, .output = 7}); }),
              "output 7 of TEX_COORD does not exist; it has 7");
}

TEST(NodeGraph, options_of_the_wrong_kind_are_named)
{
    const NodeOptions options(
        {{"text", "a"}, {"number", 1.0}, {"list", std::vector<float>{1.0f}}});
    const auto message = [](const std::function<void()>& ask) {
        try {
            ask();
        } catch (const std::invalid_argument& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(message([&] { static_cast<void>(options.number("text", 0.0)); }),
              "text is of another kind; expected a number");
    EXPECT_EQ(message([&] { static_cast<void>(options.text("number", "")); }),
              "number is of another kind; expected a text");
    EXPECT_EQ(message([&] { static_cast<void>(options.numbers("text")); }),
              "text is of another kind; expected a list of numbers");
    EXPECT_EQ(message([&] {
                  static_cast<void>(options.choice<int>("text", {{"b", 1}, {"c", 2}}));
              }),
              "text is a; expected one of b, c");
    EXPECT_EQ(options.number("unsaid", 2.5), 2.5);
    EXPECT_EQ(options.choice<int>("unsaid", {{"b", 1}, {"c", 2}}), 1);
}

TEST(NodeGraph, node_that_is_the_same_in_every_scene_is_made_once)
{
    NodeGraph graph;
    const std::size_t sky = graph.add("TEX_SKY");
    const std::size_t glass = graph.add("BSDF_GLASS");
    const std::size_t map = graph.add("UVMAP", test::options_of({{"uv_map", "a"}}));
    test::AnyResources resources;
    EXPECT_EQ(graph.node(sky).made_value(resources), graph.node(sky).made_value(resources));
    EXPECT_EQ(graph.node(glass).made_closure(resources),
              graph.node(glass).made_closure(resources));
    EXPECT_TRUE(resources.uv_layers.empty());
    EXPECT_NE(graph.node(map).made_value(resources), graph.node(map).made_value(resources));
    EXPECT_EQ(resources.uv_layers, (std::vector<std::string>{"a", "a"}));
}

TEST(NodeTypes, have_one_name_each_and_the_maker_of_their_role)
{
    std::set<std::string_view> names;
    for (const NodeType* type : node_types()) {
        EXPECT_TRUE(names.insert(type->name).second) << type->name;
        EXPECT_EQ(node_type_named(type->name), type);
        EXPECT_EQ(type->make_value != nullptr, type->role == NodeRole::Value) << type->name;
        EXPECT_EQ(type->make_closure != nullptr, type->role == NodeRole::Closure) << type->name;
        EXPECT_FALSE(type->outputs.empty()) << type->name;
        EXPECT_LE(type->outputs.size(), ProgramStep::most_outputs) << type->name;
        for (const auto* sockets : {&type->inputs}) {
            std::set<std::string_view> identifiers;
            for (const InputSocket& socket : *sockets) {
                EXPECT_TRUE(identifiers.insert(socket.identifier).second)
                    << type->name << " " << socket.identifier;
            }
        }
    }
    EXPECT_EQ(node_type_named("WOOL"), nullptr);
}

}  // namespace
}  // namespace eye_render
