// What small scenes of one feature each must plan, as people read it.

#include "render/plan.h"

#include "eye/eye_factory.h"
#include "scene_graphs.h"
#include "scenes.h"

#include <gtest/gtest.h>

#include <functional>

namespace eye_render {
namespace {

// An eye in focus, and nothing near: neither blur nor lens.
std::string plan_text(const SceneData& data, std::vector<PassRequest> passes = {Pass::Combined})
{
    RenderPlan plan = make_plan(data, std::move(passes));
    plan_lens(plan, data, test::frame(256, 0.2),
              *make_eye({.model = EyeModelKind::Pinhole, .pupil_diameter_m = 0.0}));
    return plan.text();
}

void expect_said(const std::string& text, std::initializer_list<const char*> sentences)
{
    for (const char* sentence : sentences) {
        EXPECT_NE(text.find(sentence), std::string::npos) << sentence << "\n\n" << text;
    }
}

constexpr const char* no_images =
    "images: 0 (OpenImageIO not started); UV layers read: none; attributes read: none\n";
constexpr const char* dark =
    "lights: 0 point, 0 sun, 0 spot, 0 area; emissive meshes: no; environment table: no\n";
constexpr const char* opaque = "shadows: opaque\n";
constexpr const char* no_volumes = "volumes: none\n";

SceneData square_of(const Material& material)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0, 0, -5), material);
    return data;
}

// A square of what the graph makes.
SceneData square_of(const std::function<NodeOutput(NodeGraph&)>& build)
{
    SceneData data;
    NodeGraph graph;
    const NodeOutput surface = build(graph);
    test::place(data, test::square(1.0f), V3d(0, 0, -5), test::made(data, graph, surface));
    return data;
}

TEST(PlanOfScenes, nothing_needs_nothing)
{
    expect_said(plan_text({}),
                {"geometry: 0 triangles in 0 objects, 0 meshes instanced\n", no_images, dark,
                 opaque, no_volumes, "lens: pinhole", "passes: Combined\n"});
}

TEST(PlanOfScenes, plain_principled_reads_and_emits_and_passes_nothing)
{
    expect_said(
        plan_text(square_of(plain_material("BSDF_PRINCIPLED", {}))),
        {"geometry: 2 triangles in 1 objects, 0 meshes instanced\n", no_images, dark, opaque});
}

TEST(PlanOfScenes, picture_that_lies_as_the_mesh_says_reads_the_first_layer)
{
    SceneData data;
    test::add_grey_picture(data);
    test::place(data, test::square(1.0f), V3d(0, 0, -5), test::pictured(data, ""));
    expect_said(plan_text(data),
                {"images: 1; UV layers read: the first; attributes read: none\n"});
}

TEST(PlanOfScenes, named_layers_are_read_by_their_names)
{
    SceneData data;
    test::add_grey_picture(data);
    test::place(data, test::square(1.0f), V3d(0, 0, -5), test::pictured(data, "b"));
    test::place(data, test::square(1.0f), V3d(0, 0, -5), test::pictured(data, "a"));
    expect_said(plan_text(data), {"images: 1; UV layers read: 'b', 'a'; attributes read: none\n"});
}

TEST(PlanOfScenes, material_that_nothing_wears_is_no_part_of_it)
{
    SceneData data = square_of(test::diffuse(0.5f));
    data.materials.push_back(test::pictured(data, "a"));
    data.materials.push_back(test::emission(1.0f));
    data.materials.push_back(test::transparent(0.5f));
    expect_said(plan_text(data), {no_images, dark, opaque});
}

TEST(PlanOfScenes, attribute_is_read_by_its_name)
{
    const SceneData data = square_of([](NodeGraph& graph) {
        const std::size_t layer =
            graph.add("ATTRIBUTE", test::options_of({{"attribute_name", "wear"}}));
        const std::size_t diffuse = graph.add("BSDF_DIFFUSE");
        graph.link(diffuse, "Color", graph.output(layer, "Color"));
        return graph.output(diffuse, "BSDF");
    });
    expect_said(plan_text(data), {"UV layers read: none; attributes read: 'wear'\n"});
}

TEST(PlanOfScenes, glass_casts_the_shadow_of_a_solid_but_transparency_does_not)
{
    expect_said(plan_text(square_of(plain_material("BSDF_GLASS", {}))), {opaque});
    expect_said(plan_text(square_of(test::transparent(0.5f))),
                {"shadows: materials may pass light\n"});
    expect_said(plan_text(square_of(plain_material("BSDF_PRINCIPLED", {{"Alpha", V3f(0.9f)}}))),
                {"shadows: materials may pass light\n"});
}

TEST(PlanOfScenes, mix_that_leaves_nothing_of_a_shader_does_not_have_it)
{
    for (const float share : {0.0f, 0.25f}) {
        const SceneData data = square_of([&](NodeGraph& graph) {
            const std::size_t mix = graph.add("MIX_SHADER");
            graph.set(mix, "Fac", V3f(share));
            graph.link(mix, "Shader", graph.output(graph.add("BSDF_DIFFUSE"), "BSDF"));
            graph.link(mix, "Shader_001", graph.output(graph.add("BSDF_TRANSPARENT"), "BSDF"));
            return graph.output(mix, "Shader");
        });
        expect_said(plan_text(data),
                    {share > 0.0f ? "shadows: materials may pass light\n" : opaque});
    }
}

TEST(PlanOfScenes, strength_or_colour_of_zero_is_no_light)
{
    expect_said(plan_text(square_of(test::emission(1.0f))), {"emissive meshes: yes"});
    expect_said(plan_text(square_of(test::emission(0.0f))), {dark});
    expect_said(plan_text(square_of(plain_material("EMISSION", {{"Color", V3f(0.0f)}}))), {dark});
}

TEST(PlanOfScenes, colour_in_the_place_of_a_shader_is_light)
{
    const SceneData data = square_of(
        [](NodeGraph& graph) { return graph.output(graph.add("TEX_COORD"), "Generated"); });
    expect_said(plan_text(data), {"emissive meshes: yes", "UV layers read: none"});
}

TEST(PlanOfScenes, even_world_needs_no_table_and_one_that_differs_by_direction_does)
{
    SceneData data = square_of(test::diffuse(0.5f));
    data.world = test::even_world(1.0f);
    expect_said(plan_text(data), {"environment table: no"});
    test::add_grey_picture(data);
    data.world = test::pictured_world(data);
    expect_said(plan_text(data), {"images: 1; UV layers read: none", "environment table: yes"});
    NodeGraph graph;
    const std::size_t background = graph.add("BACKGROUND");
    graph.link(background, "Color", graph.output(graph.add("TEX_COORD"), "Generated"));
    data.world = test::made(data, graph, graph.output(background, "Background"));
    expect_said(plan_text(data), {"environment table: yes"});
}

TEST(PlanOfScenes, lamps_are_told_apart)
{
    SceneData data = square_of(test::diffuse(0.5f));
    for (const LampKind kind : {LampKind::Point, LampKind::Sun, LampKind::Spot, LampKind::Spot,
                                LampKind::Area, LampKind::Area, LampKind::Area}) {
        LampData lamp = test::point_lamp(V3d(0.0), 1.0f);
        lamp.settings.kind = kind;
        data.lamps.push_back(lamp);
    }
    expect_said(plan_text(data), {"lights: 1 point, 1 sun, 2 spot, 3 area;"});
}

TEST(PlanOfScenes, mesh_placed_twice_is_one_mesh)
{
    SceneData data = square_of(test::diffuse(0.5f));
    data.instances.push_back(data.instances.front());
    data.instances.push_back(data.instances.front());
    test::place(data, test::cube(1.0f), V3d(0, 0, -9), test::diffuse(0.5f));
    expect_said(plan_text(data), {"geometry: 18 triangles in 4 objects, 1 meshes instanced\n"});
}

TEST(PlanOfScenes, passes_are_listed_in_their_order)
{
    expect_said(plan_text({}, {Pass::Combined, Pass::Blur, Pass::Depth}),
                {"passes: Combined Blur Depth\n"});
}

TEST(PlanOfScenes, volumes_are_counted_by_the_objects_that_they_fill)
{
    expect_said(plan_text(square_of(plain_material("BSDF_GLASS", {}))), {no_volumes});
    SceneData data;
    const Material mist = test::filled("VOLUME_SCATTER", {{"Density", V3f(1.0f)}});
    test::place(data, test::cube(1.0f), V3d(0, 0, -5), mist);
    test::place(data, test::cube(1.0f), V3d(0, 0, -9), mist);
    expect_said(plan_text(data),
                {"shadows: materials may pass light\n", "volumes: in 2 objects\n"});
    data.world = mist;
    expect_said(plan_text(data), {"volumes: in 2 objects and in the world\n"});
}

}  // namespace
}  // namespace eye_render
