// Closures of volumes: coefficients as Cycles has them, and which trees are the same everywhere.

#include "closure_trial.h"
#include "options_of.h"
#include "shading/material.h"
#include "shading/participating_medium.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

ShaderProgram volume_of(const NodeGraph& graph, const NodeOutput& output)
{
    test::NothingToName resources;
    return make_material("m", graph, {.volume = output}, resources).volume;
}

ParticipatingMedium medium_of(std::string_view closure,
                              std::initializer_list<std::pair<std::string_view, NodeValue>> inputs,
                              const NodeOptions& options = {})
{
    const Nowhere nowhere;
    return plain_material(closure, inputs, options).surface.medium(nowhere.hit());
}

TEST(VolumeNodes, absorption_takes_what_is_not_of_its_color)
{
    const auto medium =
        medium_of("VOLUME_ABSORPTION", {{"Color", V3f(0.8f, 0.5f, 1.5f)}, {"Density", V3f(2.0f)}});
    EXPECT_NEAR(medium.extinction.x, 0.4f, 1e-6f);
    EXPECT_FLOAT_EQ(medium.extinction.y, 1.0f);
    EXPECT_EQ(medium.extinction.z, 0.0f);
    EXPECT_FALSE(medium.is_scattering());
}

TEST(VolumeNodes, scatter_takes_what_it_scatters)
{
    const auto medium = medium_of(
        "VOLUME_SCATTER",
        {{"Color", V3f(0.8f, 0.5f, 0.0f)}, {"Density", V3f(2.0f)}, {"Anisotropy", V3f(0.3f)}});
    EXPECT_EQ(medium.extinction, Color3f(1.6f, 1.0f, 0.0f));
    EXPECT_EQ(medium.scattering(), medium.extinction);
    EXPECT_FLOAT_EQ(medium.scattered(1.0f - 0.4f).y, phase_value({.g = 0.3f}, 1.0f - 0.4f));
}

TEST(VolumeNodes, phase_functions_go_by_blenders_names)
{
    const auto value = [](const char* phase) {
        return medium_of("VOLUME_SCATTER",
                         {{"Color", V3f(1.0f)}, {"Anisotropy", V3f(0.5f)}, {"Alpha", V3f(2.0f)}},
                         test::options_of({{"phase", phase}}))
            .scattered(1.0f - 0.7f)
            .x;
    };
    EXPECT_FLOAT_EQ(value("HENYEY_GREENSTEIN"), phase_value({.g = 0.5f}, 1.0f - 0.7f));
    EXPECT_FLOAT_EQ(value("RAYLEIGH"), phase_value({.alpha = 1.0f}, 1.0f - 0.7f));
    EXPECT_FLOAT_EQ(value("DRAINE"), phase_value({.g = 0.5f, .alpha = 2.0f}, 1.0f - 0.7f));
    EXPECT_GT(value("MIE"), 0.0f);
    EXPECT_FLOAT_EQ(value("FOURNIER_FORAND"),
                    fournier_forand_pdf(fournier_forand(1.33f, 0.1f), 1.0f - 0.7f));
    EXPECT_THROW(static_cast<void>(value("ISOTROPIC")), std::invalid_argument);
}

TEST(VolumeNodes, principled_absorbs_by_the_root_of_its_absorption_color)
{
    const auto medium = medium_of("PRINCIPLED_VOLUME", {{"Color", V3f(0.5f, 0.2f, 1.0f)},
                                                        {"Density", V3f(3.0f)},
                                                        {"Absorption Color", V3f(0.25f)}});
    EXPECT_EQ(medium.scattering(), Color3f(1.5f, 0.6f, 3.0f));
    EXPECT_NEAR(medium.extinction.x, 3.0f * (0.5f + 0.5f * 0.5f), 1e-6f);
    EXPECT_NEAR(medium.extinction.y, 3.0f * (0.2f + 0.8f * 0.5f), 1e-6f);
    EXPECT_NEAR(medium.extinction.z, 3.0f, 1e-6f);
    EXPECT_EQ(medium.emission, Color3f(0.0f));
}

TEST(VolumeNodes, principled_glows_by_stefan_and_boltzmann)
{
    const auto glow = [](float intensity, float temperature_k) {
        return luminance(medium_of("PRINCIPLED_VOLUME", {{"Density", V3f(0.0f)},
                                                         {"Blackbody Intensity", V3f(intensity)},
                                                         {"Temperature", V3f(temperature_k)}})
                             .emission);
    };
    // 5.67e-8 T^4 / pi, in MW; the colour of 4000 K has luminance 1 to 2 %.
    EXPECT_NEAR(glow(1.0f, 4000.0f), 5.670373e-14f * 2.56e14f / 3.14159265f, 0.1f);
    EXPECT_NEAR(glow(1.0f, 8000.0f) / glow(1.0f, 4000.0f), 16.0f, 0.5f);
    EXPECT_EQ(glow(0.0f, 4000.0f), 0.0f);
}

TEST(VolumeNodes, coefficients_are_taken_as_they_are)
{
    const auto medium =
        medium_of("VOLUME_COEFFICIENTS", {{"Absorption Coefficients", V3f(0.5f, 0.0f, 1.0f)},
                                          {"Scatter Coefficients", V3f(1.0f, 2.0f, 0.0f)},
                                          {"Emission Coefficients", V3f(0.1f)}});
    EXPECT_EQ(medium.extinction, Color3f(1.5f, 2.0f, 1.0f));
    EXPECT_EQ(medium.scattering(), Color3f(1.0f, 2.0f, 0.0f));
    EXPECT_EQ(medium.emission, Color3f(0.1f));
}

TEST(VolumeNodes, mixes_and_sums_weigh_media)
{
    NodeGraph graph;
    const std::size_t scatter = graph.add("VOLUME_SCATTER");
    const std::size_t glow = graph.add("EMISSION");
    const std::size_t mix = graph.add("MIX_SHADER");
    graph.set(scatter, "Color", V3f(1.0f));
    graph.set(mix, "Fac", V3f(0.25f));
    graph.link(mix, "Shader", graph.output(scatter, "Volume"));
    graph.link(mix, "Shader_001", graph.output(glow, "Emission"));
    const Nowhere nowhere;
    const auto medium = volume_of(graph, graph.output(mix, "Shader")).medium(nowhere.hit());
    EXPECT_FLOAT_EQ(medium.extinction.x, 0.75f);
    EXPECT_FLOAT_EQ(medium.emission.x, 0.25f);
}

TEST(VolumeNodes, do_nothing_as_a_surface)
{
    const ShadedPoint shaded = test::ClosureTrial("VOLUME_SCATTER").shade(test::seen_at(10.0));
    EXPECT_TRUE(shaded.bsdf.is_delta_only());
    EXPECT_EQ(shaded.emission, Color3f(0.0f));
}

TEST(VolumeNodes, a_surface_of_nothing_around_a_volume_is_clear)
{
    NodeGraph graph;
    const NodeOutput volume{.node = graph.add("VOLUME_SCATTER")};
    test::NothingToName resources;
    const Material mist = make_material("m", graph, {.volume = volume}, resources);
    EXPECT_TRUE(mist.has_volume());
    EXPECT_TRUE(mist.surface.may_be_transparent());
    EXPECT_FALSE(make_material("m", graph, {}, resources).surface.may_be_transparent());
}

TEST(VolumeNodes, vary_in_space_where_they_read_more_than_the_object)
{
    const auto varies = [](const char* kind, const char* output) {
        NodeGraph graph;
        const std::size_t source = graph.add(kind);
        const std::size_t scatter = graph.add("VOLUME_SCATTER");
        graph.link(scatter, "Density", graph.output(source, output));
        return volume_of(graph, graph.output(scatter, "Volume")).varies_in_space();
    };
    EXPECT_FALSE(varies("VALUE", "Value"));
    EXPECT_FALSE(varies("OBJECT_INFO", "Random"));
    EXPECT_TRUE(varies("TEX_NOISE", "Fac"));
    EXPECT_TRUE(varies("TEX_COORD", "Object"));
}

}  // namespace
}  // namespace eye_render
