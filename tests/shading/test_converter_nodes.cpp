// Converter, vector and colour nodes against what Cycles of Blender 4.3 made of the same inputs
// (tests/tools/converter_references.py): every operation and option, with zeros, infinities and
// what is not a number among the inputs.

#include "converter_references.h"

#include <cmath>
#include <limits>
#include <set>

namespace eye_render::test {
namespace {

// Relative to the greatest number that takes part.
double relative_tolerance(const std::string& node)
{
    // Cycles is compiled to reorder and fuse operations: each may round otherwise, a few times
    // over.
    constexpr double roundings = 16.0 * std::numeric_limits<float>::epsilon();
    // Its luminance has the weights of Rec. 709 to seven digits, where the standard gives four.
    constexpr double digits_of_luminance = 8e-5;
    // Its colour matrix is computed from the primaries, ours is the published one.
    constexpr double digits_of_matrix = 1e-5;
    // It takes blackbodies from a fit of its own, good to a thousandth.
    constexpr double blackbody_fit = 1.2e-3;
    if (node == "RGBTOBW") {
        return digits_of_luminance;
    }
    if (node == "WAVELENGTH") {
        return digits_of_matrix;
    }
    return node == "BLACKBODY" ? blackbody_fit : roundings;
}

double magnitude(const NodeValue& v)
{
    double greatest = 0.0;
    for (int i = 0; i < 3; ++i) {
        const double size = std::abs(double(v[i]));
        greatest = std::isfinite(size) ? std::max(greatest, size) : greatest;
    }
    return greatest;
}

// What Blender leaves without an answer is nobody's to match.
void expect_near(const NodeValue& made, const NodeValue& expected, double within)
{
    for (int i = 0; i < 3; ++i) {
        if (std::isfinite(expected[i])) {
            EXPECT_NEAR(made[i], expected[i], within) << "component " << i;
        }
    }
}

void expect_case(const Json& reference)
{
    const std::string name = reference["node"];
    const NodeType* type = node_type_named(name);
    ASSERT_NE(type, nullptr) << name;
    if (type->reads_hit) {
        return;  // see test_placed_nodes.cpp
    }
    NodeTrial trial(*type, options_of(reference["options"]));
    const MadeUpHit hit;
    // Kelvin and nanometres are in no proportion to a colour.
    const bool is_spectral = name == "BLACKBODY" || name == "WAVELENGTH";
    for (const auto& [output, rows] : reference["outputs"].items()) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            std::string said;
            double scale = std::max(magnitude(value_of(rows[row])), 1.0);
            for (const auto& [input, channel] : reference["inputs"].items()) {
                const Json& given = references()["channels"][channel.get<std::string>()][row];
                trial.set(input, value_of(given));
                scale = is_spectral ? scale : std::max(scale, magnitude(value_of(given)));
                said += " " + input + " " + given.dump();
            }
            SCOPED_TRACE(output + " of" + said);
            expect_near(trial(output, hit), value_of(rows[row]), relative_tolerance(name) * scale);
        }
    }
    EXPECT_EQ(hit.questions, 0) << "but its row says that it reads nothing of the hit";
}

TEST(ConverterNodes, answer_as_cycles_does)
{
    ASSERT_FALSE(references()["cases"].empty());
    for (const Json& reference : references()["cases"]) {
        std::string said = reference["node"];
        for (const auto& [option, value] : reference["options"].items()) {
            said += value.is_array() ? "" : " " + option + " " + value.dump();
        }
        SCOPED_TRACE(said);
        expect_case(reference);
    }
}

TEST(ConverterNodes, all_have_references)
{
    const std::set<std::string_view> constants{"VALUE", "RGB"};
    for (const auto& family : {math_nodes(), color_nodes()}) {
        for (const NodeType& type : family) {
            const bool is_here =
                std::ranges::any_of(references()["cases"], [&](const Json& reference) {
                    return reference["node"].get<std::string>() == type.name;
                });
            EXPECT_NE(is_here, constants.contains(type.name)) << type.name;
        }
    }
}

TEST(ConverterNodes, constants_are_what_they_are_told)
{
    EXPECT_EQ(NodeTrial(*node_type_named("VALUE"), {{"value", 0.25}})("Value").x, 0.25f);
    const std::vector<float> rgba{0.1f, 0.2f, 0.3f, 1.0f};
    EXPECT_EQ(NodeTrial(*node_type_named("RGB"), {{"value", rgba}})("Color"),
              NodeValue(0.1f, 0.2f, 0.3f));
}

TEST(ConverterNodes, operations_that_came_after_4_3_go_by_component)
{
    const auto made = [](const char* operation) {
        return NodeTrial(*node_type_named("VECT_MATH"), {{"operation", operation}})
            .set("Vector", NodeValue(-2.0f, 0.0f, 2.5f))
            .set("Vector_001", NodeValue(2.0f, 3.0f, 0.5f))("Vector");
    };
    EXPECT_EQ(made("POWER"), NodeValue(4.0f, 0.0f, std::sqrt(2.5f)));
    EXPECT_EQ(made("SIGN"), NodeValue(-1.0f, 0.0f, 1.0f));
    EXPECT_EQ(made("ROUND"), NodeValue(-2.0f, 0.0f, 3.0f));
}

TEST(ConverterNodes, refuse_what_they_do_not_know)
{
    const auto make = [](const char* node, Options options) {
        return NodeTrial(*node_type_named(node), std::move(options));
    };
    EXPECT_THROW(make("MATH", {{"operation", "FLY"}}), std::invalid_argument);
    EXPECT_THROW(make("VECT_MATH", {{"operation", "FLY"}}), std::invalid_argument);
    EXPECT_THROW(make("MIX", {{"data_type", "ROTATION"}}), std::invalid_argument);
    EXPECT_THROW(make("MIX_RGB", {{"blend_type", "FLY"}}), std::invalid_argument);
    EXPECT_THROW(make("RGB", {{"value", std::vector<float>{1.0f, 2.0f}}}), std::invalid_argument);
}

TEST(ConverterNodes, refuse_tables_that_are_none)
{
    const auto make = [](const char* node, Options options) {
        return NodeTrial(*node_type_named(node), std::move(options));
    };
    const std::vector<float> four{0.0f, 0.2f, 0.4f, 1.0f};
    EXPECT_NO_THROW(make("CURVE_FLOAT", {{"curve", four}}));
    EXPECT_THROW(make("CURVE_FLOAT", {}), std::invalid_argument);
    EXPECT_THROW(make("CURVE_FLOAT", {{"curve", four}, {"curve_max", 0.0}}),
                 std::invalid_argument);
    EXPECT_THROW(make("CURVE_RGB", {{"curve", four}}), std::invalid_argument);
    EXPECT_THROW(make("VALTORGB", {{"ramp", four}}), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render::test
