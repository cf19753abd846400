// The procedural textures as nodes: sockets, options and inputs of any value.

#include "node_trial.h"
#include "texture_references.h"

#include "shading/nodes/node_tables.h"

#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <sstream>

namespace eye_render::test {
namespace {

const NodeType& texture_node(std::string_view name)
{
    const auto types = procedural_texture_nodes();
    return *std::ranges::find(types, name, &NodeType::name);
}

// Every set of options in the tables.
std::set<Options> options_of(const NodeType& type)
{
    std::string table(type.name);
    std::ranges::transform(table, table.begin(), [](char c) { return std::tolower(c); });
    std::set<Options> all;
    for (const ReferenceRow& row : reference_table(table)) {
        all.insert(row.options);
    }
    return all;
}

TEST(ProceduralNodes, answer_numbers_to_whatever_they_are_asked)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    constexpr float greatest = std::numeric_limits<float>::max();
    constexpr float least = std::numeric_limits<float>::denorm_min();
    const std::vector<float> extremes{std::nanf(""), infinity,     -infinity, greatest, -greatest,
                                      least,         -least,       0.0f,      -0.0f,    1e30f,
                                      -1e30f,        2147483648.f, 1e9f,      -1e9f,    1e-30f,
                                      100000.0f,     -1.0f,        0.5f,      3.0f};
    std::mt19937 random(1);
    const auto extreme = [&] { return extremes[random() % extremes.size()]; };
    for (const NodeType& type : procedural_texture_nodes()) {
        for (const Options& options : options_of(type)) {
            NodeTrial trial(type, options);
            for (int i = 0; i < 25; ++i) {
                std::ostringstream asked;
                asked << type.name;
                for (const InputSocket& socket : type.inputs) {
                    // Half of the inputs stay ordinary. Colours are only passed on.
                    if (socket.type == SocketType::Color || random() % 2 == 0) {
                        continue;
                    }
                    const NodeValue value(extreme(), extreme(), extreme());
                    trial.set(socket.identifier, value);
                    asked << " " << socket.identifier << "=" << value;
                }
                trial.set("Vector", {extreme(), extreme(), extreme()});
                for (const OutputSocket& output : type.outputs) {
                    const NodeValue value = trial(output.identifier);
                    EXPECT_TRUE(std::isfinite(value.x) && std::isfinite(value.y) &&
                                std::isfinite(value.z))
                        << asked.str() << " gives " << output.identifier << " " << value;
                }
            }
        }
    }
}

TEST(ProceduralNodes, are_looked_up_at_generated_coordinates_unless_linked_but_white_noise)
{
    MadeUpHit hit;
    hit.p_generated = {0.3f, 0.6f, 0.9f};
    for (const NodeType& type : procedural_texture_nodes()) {
        const std::string_view output = type.outputs[0].identifier;
        if (type.name == "TEX_WHITE_NOISE") {
            EXPECT_EQ(NodeTrial(type)(output, hit), NodeTrial(type)(output)) << type.name;
            continue;
        }
        NodeTrial unlinked(type);
        NodeTrial linked(type);
        linked.set("Vector", hit.p_generated);
        EXPECT_EQ(unlinked(output, hit), linked(output)) << type.name;
    }
}

TEST(ProceduralNodes, gradient_ends_where_blenders_does)
{
    NodeTrial gradient(texture_node("TEX_GRADIENT"));
    EXPECT_EQ(gradient.set("Vector", {-2.0f, 0.0f, 0.0f})("Fac").x, 0.0f);
    EXPECT_EQ(gradient.set("Vector", {0.25f, 0.0f, 0.0f})("Fac").x, 0.25f);
    EXPECT_EQ(gradient.set("Vector", {7.0f, 0.0f, 0.0f})("Fac").x, 1.0f);
}

TEST(ProceduralNodes, rounding_at_zero_does_not_change_a_checkers_color)
{
    NodeTrial checker(texture_node("TEX_CHECKER"));
    checker.set("Scale", 1.0f);
    const NodeValue above = checker.set("Vector", {0.5f, 0.5f, 1e-7f})("Fac");
    const NodeValue below = checker.set("Vector", {0.5f, 0.5f, -1e-7f})("Fac");
    EXPECT_EQ(above, below);
}

TEST(ProceduralNodes, joints_have_sharp_edges_where_their_softness_is_below_zero)
{
    for (const float smooth : {0.0f, -0.3f}) {
        NodeTrial brick(texture_node("TEX_BRICK"));
        brick.set("Scale", 1.0f).set("Mortar Size", 0.1f).set("Mortar Smooth", smooth);
        EXPECT_EQ(brick.set("Vector", {0.1f, 0.05f, 0.0f})("Fac").x, 1.0f) << smooth;
        EXPECT_EQ(brick.set("Vector", {0.1f, 0.125f, 0.0f})("Fac").x, 0.0f) << smooth;
    }
}

TEST(ProceduralNodes, bricks_without_width_have_joints_between_their_rows_alone)
{
    NodeTrial brick(texture_node("TEX_BRICK"), {{"squash", 0.0}, {"squash_frequency", 1.0}});
    brick.set("Scale", 1.0f).set("Mortar Size", 0.02f).set("Row Height", 0.25f);
    for (const float x : {-3.3f, 0.01f, 0.7f}) {
        EXPECT_EQ(brick.set("Vector", {x, 0.125f, 0.0f})("Fac").x, 0.0f) << x;
        EXPECT_GT(brick.set("Vector", {x, 0.251f, 0.0f})("Fac").x, 0.9f) << x;
    }
}

TEST(ProceduralNodes, magic_repeats_every_turn_of_its_unscaled_coordinates)
{
    NodeTrial magic(texture_node("TEX_MAGIC"), {{"turbulence_depth", 5.0}});
    magic.set("Scale", 1.37f);
    const float turn = 6.2831855f;
    const NodeValue here = magic.set("Vector", {1.0f, 2.0f, 0.5f})("Color");
    const NodeValue there = magic.set("Vector", {1.0f + turn, 2.0f + 3.0f * turn, 0.5f})("Color");
    // Five folds, each of which doubles the rounding of the coordinates.
    EXPECT_LT((here - there).length(), 1e-4f) << here << there;
}

TEST(ProceduralNodes, refuse_options_out_of_range)
{
    const auto made = [](std::string_view type, Options options) {
        NodeTrial(texture_node(type), std::move(options));
    };
    EXPECT_THROW(made("TEX_NOISE", {{"noise_dimensions", "5D"}}), std::invalid_argument);
    EXPECT_THROW(made("TEX_VORONOI", {{"feature", "F3"}}), std::invalid_argument);
    EXPECT_THROW(made("TEX_MAGIC", {{"turbulence_depth", 11.0}}), std::invalid_argument);
    EXPECT_THROW(made("TEX_BRICK", {{"offset_frequency", 0.0}}), std::invalid_argument);
    EXPECT_THROW(made("TEX_BRICK", {{"squash", std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render::test
