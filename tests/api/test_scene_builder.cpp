#include "api/scene_builder.h"

#include "../shading/options_of.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace eye_render {
namespace {

std::string refusal(const std::function<void()>& call)
{
    try {
        call();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

Mesh two_triangles()
{
    Mesh mesh;
    mesh.name = "pair";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {std::nanf(""), 1, 0}};
    mesh.triangles = {{1, 2, 3}, {0, 1, 2}};
    mesh.material_slots = {4, 7};
    mesh.uv_layers = {{"UV", {{0, 0}, {0, 0}, {0, 0}, {1, 1}, {2, 2}, {3, 3}}}};
    return mesh;
}

TEST(SceneBuilder, triangles_without_a_place_are_left_out_with_a_warning)
{
    SceneBuilder scene;
    scene.add_geometry(two_triangles());
    const Mesh& mesh = std::get<Mesh>(scene.data().geometries[0]);
    ASSERT_EQ(mesh.triangles.size(), 1u);
    EXPECT_EQ(mesh.triangles[0], (TriangleIndices{0, 1, 2}));
    EXPECT_EQ(mesh.material_slots, std::vector<std::int32_t>{7});
    EXPECT_EQ(mesh.uv_layers[0].per_corner[2], V2f(3, 3));
    ASSERT_EQ(scene.warnings().size(), 1u);
    EXPECT_NE(scene.warnings()[0].find("pair"), std::string::npos);
}

TEST(SceneBuilder, refuses_what_does_not_exist)
{
    SceneBuilder scene;
    EXPECT_EQ(refusal([&] {
                  scene.add_instance({.geometry = 2, .world_from_object = {}, .materials = {}});
              }),
              "geometry 2 does not exist; there are 0");
    EXPECT_EQ(refusal([&] { static_cast<void>(scene.camera()); }), "the scene has no camera");
}

TEST(SceneBuilder, refuses_a_camera_that_sees_nothing)
{
    SceneBuilder scene;
    CameraFrame frame;
    frame.width_px = 0;
    EXPECT_EQ(refusal([&] { scene.set_camera(frame); }),
              "resolution x is 0 px; expected 1 to 65536 px");
    frame.width_px = frame.height_px = 8;
    frame.border = {0, 0, 8, 9};
    EXPECT_EQ(refusal([&] { scene.set_camera(frame); }), "border y1 is 9 px; expected 1 to 8 px");
}

TEST(SceneBuilder, layers_that_a_material_reads_have_one_number_each)
{
    SceneBuilder scene;
    const std::vector<float> pixel(4, 1.0f);
    scene.textures().add_pixels("p", PixelsF32{.width = 1, .height = 1, .rgba = pixel}, {});
    const auto textured = [&scene](const std::string& layer) {
        NodeGraph graph;
        const std::size_t map = graph.add("UVMAP", test::options_of({{"uv_map", layer}}));
        const std::size_t image = graph.add("TEX_IMAGE", test::options_of({{"texture", 0.0}}));
        const std::size_t emission = graph.add("EMISSION");
        graph.link(image, "Vector", graph.output(map, "UV"));
        graph.link(emission, "Color", graph.output(image, "Color"));
        return scene.add_material(layer, graph, {.surface = graph.output(emission, "Emission")});
    };
    const std::size_t first = textured("b");
    const std::size_t second = textured("a");
    const std::size_t third = textured("b");
    const std::size_t active = textured("");
    EXPECT_EQ(scene.data().uv_layer_names, (std::vector<std::string>{"", "b", "a"}));
    EXPECT_EQ(scene.data().materials[first].uv_layers, scene.data().materials[third].uv_layers);
    EXPECT_EQ(scene.uv_layers_read({second, first}), (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(scene.uv_layers_read({active}), std::vector<std::string>{""});
}

TEST(SceneBuilder, attributes_that_no_material_reads_have_no_number)
{
    SceneBuilder scene;
    NodeGraph graph;
    const std::size_t read =
        graph.add("ATTRIBUTE", test::options_of({{"attribute_name", "wear"}}));
    graph.add("ATTRIBUTE", test::options_of({{"attribute_name", "unread"}}));
    const std::size_t emission = graph.add("EMISSION");
    graph.link(emission, "Color", graph.output(read, "Color"));
    const std::size_t number =
        scene.add_material("m", graph, {.surface = graph.output(emission, "Emission")}, 3);
    EXPECT_EQ(scene.attributes_read({number}), std::vector<std::string>{"wear"});
    EXPECT_EQ(scene.data().attribute_names, std::vector<std::string>{"wear"});
    EXPECT_EQ(scene.data().materials[number].pass_index, 3);
}

TEST(SceneBuilder, refuses_a_texture_that_does_not_exist)
{
    SceneBuilder scene;
    NodeGraph graph;
    const std::size_t image = graph.add("TEX_IMAGE", test::options_of({{"texture", 2.0}}));
    const std::optional<NodeOutput> surface = graph.output(image, "Color");
    EXPECT_EQ(refusal([&] { scene.add_material("m", graph, {.surface = surface}); }),
              "texture 2 does not exist; there are 0");
    EXPECT_TRUE(scene.data().materials.empty());
}

TEST(SceneBuilder, aims_at_the_sun_of_the_sky_that_the_world_shows)
{
    NodeGraph graph;
    graph.add("TEX_SKY", test::options_of({{"sun_elevation", 0.2}}));  // left lying about
    const std::size_t shown = graph.add("TEX_SKY", test::options_of({{"sun_elevation", 0.9}}));
    const std::size_t background = graph.add("BACKGROUND");
    const MaterialOutputs outputs{.surface = graph.output(background, "Background")};
    SceneBuilder scene;
    scene.set_world(graph, outputs);
    EXPECT_FALSE(scene.data().world_sun) << "a world of one colour";
    graph.link(background, "Color", graph.output(shown, "Color"));
    scene.set_world(graph, outputs);
    ASSERT_TRUE(scene.data().world_sun);
    EXPECT_NEAR(scene.data().world_sun->direction.z, std::sin(0.9), 0.02);
}

}  // namespace
}  // namespace eye_render
