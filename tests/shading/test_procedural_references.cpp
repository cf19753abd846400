// The procedural textures against Blender 4.3's own, over all their options: the tables of
// tests/tools/texture_references.py.

#include "node_trial.h"
#include "texture_references.h"

#include "shading/nodes/node_tables.h"

#include <cmath>
#include <limits>
#include <random>

namespace eye_render::test {
namespace {

const NodeType& texture_node(std::string_view name)
{
    for (const NodeType& type : procedural_texture_nodes()) {
        if (type.name == name) {
            return type;
        }
    }
    throw std::invalid_argument("no texture " + std::string(name));
}

NodeTrial trial_of(const NodeType& type, const ReferenceRow& row)
{
    NodeTrial trial(type, row.options);
    for (const auto& [identifier, value] : row.inputs) {
        trial.set(identifier, value);
    }
    return trial;
}

// How far rounding lets answers be apart.
struct Rounding {
    double relative = 0.0;     // of the last operations, to 1 and to the answer
    float added_place = 0.0f;  // what a texture adds to its coordinates, losing their last digits
};

// Moved by up to four units in the last place: about as many operations lie between a coordinate
// and what it is used for.
float nudged(float x, const Rounding& rounding, std::mt19937& random)
{
    const auto units = static_cast<float>(std::uniform_int_distribution(-4, 4)(random));
    const float unit = std::numeric_limits<float>::epsilon() / 2.0f;
    return x + units * unit * (std::abs(x) + rounding.added_place);
}

// What the texture answers where coordinates differ by rounding.
struct Spread {
    V3f least{std::numeric_limits<float>::max()};
    V3f most{-std::numeric_limits<float>::max()};
};

Spread spread_around(const NodeType& type,
                     const ReferenceRow& row,
                     const std::string& output,
                     const Rounding& rounding)
{
    std::mt19937 random(1);
    Spread spread;
    for (int i = 0; i < 32; ++i) {
        NodeTrial trial = trial_of(type, row);
        for (const char* input : {"Vector", "W"}) {
            if (const auto found = row.inputs.find(input); found != row.inputs.end()) {
                const V3f& p = found->second;
                trial.set(input, {nudged(p.x, rounding, random), nudged(p.y, rounding, random),
                                  nudged(p.z, rounding, random)});
            }
        }
        const NodeValue answer = trial(output);
        for (int channel = 0; channel < 3; ++channel) {
            spread.least[channel] = std::min(spread.least[channel], answer[channel]);
            spread.most[channel] = std::max(spread.most[channel], answer[channel]);
        }
    }
    return spread;
}

struct Tally {
    int rows = 0;
    int sensitive_rows = 0;  // with an answer that needed the spread
};

// Every answer is Blender's, within the rounding of the last operations or, where coordinates are
// large or folded often, between what neighbouring coordinates give.
Tally expect_as_blender(const std::string& table, const Rounding& rounding)
{
    std::string name = table;
    std::ranges::transform(name, name.begin(), [](char c) { return std::toupper(c); });
    const NodeType& type = texture_node(name);
    Tally tally;
    for (const ReferenceRow& row : reference_table(table)) {
        const NodeTrial trial = trial_of(type, row);
        bool is_sensitive = false;
        for (const auto& [output, expected] : row.outputs) {
            const NodeValue answer = trial(output);
            for (int channel = 0; channel < 3; ++channel) {
                const double wanted = expected[channel];
                const double margin = rounding.relative * (1.0 + std::abs(wanted));
                if (std::abs(answer[channel] - wanted) <= margin) {
                    continue;
                }
                is_sensitive = true;
                const Spread spread = spread_around(type, row, output, rounding);
                EXPECT_TRUE(wanted >= spread.least[channel] - margin &&
                            wanted <= spread.most[channel] + margin)
                    << table << ".csv:" << row.line << ", channel " << channel << " of " << output
                    << " is " << answer[channel] << ", in Blender " << wanted;
            }
        }
        ++tally.rows;
        tally.sensitive_rows += is_sensitive ? 1 : 0;
    }
    return tally;
}

// The same operations in the same order.
constexpr Rounding exact{};
// Sixteen octaves, each rounded otherwise by a compiler that may reorder operations.
constexpr Rounding rounded{.relative = 16.0 * std::numeric_limits<float>::epsilon()};
// Colours and distortion are noise at up to 200 units from the value's.
constexpr Rounding rounded_noise{.relative = rounded.relative, .added_place = 200.0f};

TEST(ProceduralReferences, noise_of_every_type_and_dimension)
{
    const Tally tally = expect_as_blender("tex_noise", rounded_noise);
    EXPECT_EQ(tally.rows, 768);
    EXPECT_LT(tally.sensitive_rows, 20);
}

TEST(ProceduralReferences, white_noise_has_blenders_bits)
{
    EXPECT_EQ(expect_as_blender("tex_white_noise", exact).sensitive_rows, 0);
}

TEST(ProceduralReferences, voronoi_of_every_feature_metric_and_dimension)
{
    const Tally tally = expect_as_blender("tex_voronoi", rounded);
    EXPECT_EQ(tally.rows, 1440);
    EXPECT_EQ(tally.sensitive_rows, 0);
}

TEST(ProceduralReferences, wave_of_every_kind)
{
    const Tally tally = expect_as_blender("tex_wave", rounded);
    EXPECT_EQ(tally.rows, 480);
    EXPECT_LT(tally.sensitive_rows, 30);
}

TEST(ProceduralReferences, magic_of_every_depth)
{
    const Tally tally = expect_as_blender("tex_magic", rounded);
    EXPECT_EQ(tally.rows, 264);
    EXPECT_LT(tally.sensitive_rows, 30);
}

TEST(ProceduralReferences, bricks)
{
    const Tally tally = expect_as_blender("tex_brick", rounded);
    EXPECT_EQ(tally.rows, 400);
    EXPECT_EQ(tally.sensitive_rows, 0);
}

TEST(ProceduralReferences, checkers)
{
    EXPECT_EQ(expect_as_blender("tex_checker", exact).sensitive_rows, 0);
}

TEST(ProceduralReferences, gabor_in_the_plane_and_in_space)
{
    const Tally tally = expect_as_blender("tex_gabor", rounded);
    EXPECT_EQ(tally.rows, 300);
    EXPECT_LT(tally.sensitive_rows, 150);  // phases of waves that nearly cancel
}

TEST(ProceduralReferences, gradients)
{
    const Tally tally = expect_as_blender("tex_gradient", rounded);
    EXPECT_EQ(tally.rows, 210);
    EXPECT_EQ(tally.sensitive_rows, 0);
}

}  // namespace
}  // namespace eye_render::test
