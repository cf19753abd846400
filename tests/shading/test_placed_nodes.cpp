// Nodes that ask where the hit is: Vector Transform and Light Falloff, against Cycles.

#include "converter_references.h"

#include <cmath>

namespace eye_render::test {
namespace {

// Blender writes matrices for column vectors.
M44f matrix_of(const Json& rows)
{
    M44f m;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            m[j][i] = rows[std::size_t(i)][std::size_t(j)].get<float>();
        }
    }
    return m;
}

MadeUpHit placed_hit()
{
    MadeUpHit hit;
    hit.facts.world_from_object = matrix_of(references()["world_from_object"]);
    hit.facts.object_from_world = hit.facts.world_from_object.inverse();
    hit.camera.camera_from_world = matrix_of(references()["world_from_camera"]).inverse();
    return hit;
}

// Matrices are inverted in single precision, and the points are a few units from every origin.
constexpr float rounding = 4e-5f;

void expect_rows(const Json& reference, const PathState& path)
{
    const MadeUpHit hit = placed_hit();
    NodeTrial trial(*node_type_named(reference["node"].get<std::string>()),
                    options_of(reference["options"]));
    for (const auto& [output, rows] : reference["outputs"].items()) {
        for (std::size_t row = 0; row < rows.size(); ++row) {
            for (const auto& [input, channel] : reference["inputs"].items()) {
                trial.set(input,
                          value_of(references()["channels"][channel.get<std::string>()][row]));
            }
            const NodeValue made = trial(output, hit, path);
            const NodeValue expected = value_of(rows[row]);
            const float scale = std::max(expected.length(), 1.0f);
            EXPECT_LE((made - expected).length(), rounding * scale)
                << reference["options"] << " " << output << ", row " << row << ": " << made
                << " instead of " << expected;
        }
    }
}

TEST(PlacedNodes, vectors_change_spaces_as_in_cycles)
{
    int cases = 0;
    for (const Json& reference : references()["cases"]) {
        if (reference["node"] == "VECT_TRANSFORM") {
            expect_rows(reference, {});
            ++cases;
        }
    }
    EXPECT_EQ(cases, 27);
}

TEST(PlacedNodes, light_falls_off_with_the_length_of_the_ray_as_in_cycles)
{
    int cases = 0;
    for (const Json& reference : references()["cases"]) {
        if (reference["node"] == "LIGHT_FALLOFF") {
            expect_rows(reference, {.length = references()["ray_length"].get<float>()});
            ++cases;
        }
    }
    EXPECT_EQ(cases, 1);
}

TEST(PlacedNodes, light_from_infinity_is_not_smoothed)
{
    NodeTrial trial(*node_type_named("LIGHT_FALLOFF"));
    trial.set("Strength", 3.0f).set("Smooth", 2.0f);
    const PathState from_far{.length = std::numeric_limits<float>::max()};
    EXPECT_EQ(trial("Quadratic", MadeUpHit(), from_far).x, 3.0f);
}

}  // namespace
}  // namespace eye_render::test
