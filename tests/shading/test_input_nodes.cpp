// Nodes that read path, object, view and angle. What Cycles makes of them on meshes is tested in
// tests/scene/test_nodes_beside_cycles.cpp.

#include "asked_node.h"
#include "scattering.h"
#include "shading/fresnel.h"

#include <gtest/gtest.h>

#include <array>

namespace eye_render {
namespace {

using test::AskedNode;
using test::direction_at;
using test::MadeUpHit;
using test::up;

ShadingPoint seen_at(double angle_deg, bool backfacing = false)
{
    return {.wo = direction_at(angle_deg), .ng = up, .ns = up, .backfacing = backfacing};
}

TEST(LightPathNode, tells_every_fact_of_the_path_by_its_own_name)
{
    using Output = std::pair<const char*, void (*)(PathState&)>;
    const std::array<Output, 13> outputs{
        {{"Is Camera Ray", [](PathState& p) { p.is_camera = true; }},
         {"Is Shadow Ray", [](PathState& p) { p.is_shadow = true; }},
         {"Is Diffuse Ray", [](PathState& p) { p.is_diffuse = true; }},
         {"Is Glossy Ray", [](PathState& p) { p.is_glossy = true; }},
         {"Is Singular Ray", [](PathState& p) { p.is_singular = true; }},
         {"Is Reflection Ray", [](PathState& p) { p.is_reflection = true; }},
         {"Is Transmission Ray", [](PathState& p) { p.is_transmission = true; }},
         {"Ray Length", [](PathState& p) { p.length = 1.0f; }},
         {"Ray Depth", [](PathState& p) { p.depth = 1; }},
         {"Diffuse Depth", [](PathState& p) { p.diffuse_depth = 1; }},
         {"Glossy Depth", [](PathState& p) { p.glossy_depth = 1; }},
         {"Transparent Depth", [](PathState& p) { p.transparent_depth = 1; }},
         {"Transmission Depth", [](PathState& p) { p.transmission_depth = 1; }}}};
    const AskedNode node{.type = "LIGHT_PATH"};
    const ShadingPoint point = seen_at(0.0);
    const MadeUpHit hit;
    for (const auto& [told, tell] : outputs) {
        PathState path{.is_camera = false};
        tell(path);
        for (const auto& [output, unused] : outputs) {
            const float found = node(output, {.point = point, .attributes = hit, .path = path}).x;
            EXPECT_EQ(found, std::string_view(output) == told ? 1.0f : 0.0f)
                << output << " of a path that has " << told;
        }
    }
    EXPECT_EQ(hit.questions, 0);
}

TEST(ObjectInfoNode, tells_the_object_that_was_hit)
{
    MadeUpHit hit;
    hit.facts.world_from_object.setTranslation(V3f(1, 2, 3));
    hit.facts.color = Color4f(0.1f, 0.2f, 0.3f, 0.4f);
    hit.facts.pass_index = 5.0f;
    hit.facts.material_index = 6.0f;
    hit.facts.random = 0.75f;
    const AskedNode node{.type = "OBJECT_INFO"};
    const auto told = [&](const char* output) { return node(output, hit, seen_at(0.0)); };
    EXPECT_EQ(told("Location"), V3f(1, 2, 3));
    EXPECT_EQ(told("Color"), V3f(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(told("Alpha"), V3f(0.4f));
    EXPECT_EQ(told("Object Index"), V3f(5.0f));
    EXPECT_EQ(told("Material Index"), V3f(6.0f));
    EXPECT_EQ(told("Random"), V3f(0.75f));
}

TEST(CameraDataNode, counts_depth_along_the_view_and_distance_along_the_ray)
{
    MadeUpHit hit;
    hit.p_world = V3f(5, 3, -2);
    hit.camera.camera_from_world.setTranslation(V3f(-2, 1, -10));
    // At (3, 4, -12) before the camera, which looks along -Z: 13 away.
    const AskedNode node{.type = "CAMERA"};
    const ShadingPoint point = seen_at(0.0);
    EXPECT_LT((node("View Vector", hit, point) - V3f(3, 4, 12) / 13.0f).length(), 1e-6f);
    EXPECT_EQ(node("View Z Depth", hit, point).x, 12.0f);
    EXPECT_EQ(node("View Distance", hit, point).x, 13.0f);
    hit.p_world = V3f(2, -1, 10);
    EXPECT_EQ(node("View Vector", hit, point), V3f(0.0f)) << "no direction to where it stands";
}

TEST(FresnelNode, reflects_as_a_dielectric_from_either_side)
{
    const MadeUpHit hit;
    const auto reflectance = [&](float ior, const ShadingPoint& point) {
        return AskedNode{.type = "FRESNEL", .inputs = {{"IOR", V3f(ior)}}}("Fac", hit, point).x;
    };
    EXPECT_FLOAT_EQ(reflectance(1.5f, seen_at(0.0)), 0.04f);
    EXPECT_FLOAT_EQ(reflectance(1.5f, seen_at(0.0, true)), 0.04f);
    // Beyond asin(1 / 1.5) = 41.8 degrees, from inside, all is reflected.
    EXPECT_FLOAT_EQ(reflectance(1.5f, seen_at(42.0, true)), 1.0f);
    EXPECT_LT(reflectance(1.5f, seen_at(41.0, true)), 0.6f);
    // Brewster's angle: half of the light, polarised across, is reflected by ((n^2-1)/(n^2+1))^2.
    EXPECT_NEAR(reflectance(1.5f, seen_at(56.30993)), 0.5f * std::pow(1.25f / 3.25f, 2.0f), 1e-5f);
    EXPECT_FLOAT_EQ(reflectance(-1.0f, seen_at(30.0)), 1.0f) << "no index is that low";
}

TEST(FresnelNode, a_bent_normal_takes_the_place_of_the_surfaces)
{
    const MadeUpHit hit;
    const AskedNode bent{.type = "FRESNEL",
                         .inputs = {{"IOR", V3f(1.5f)}, {"Normal", direction_at(60.0)}}};
    EXPECT_FLOAT_EQ(bent("Fac", hit, seen_at(60.0)).x, 0.04f);
    // Turned from the viewer it counts as its other side.
    EXPECT_FLOAT_EQ(bent("Fac", hit, seen_at(-120.0)).x, 0.04f);
}

TEST(FresnelNode, takes_a_normal_as_long_as_it_is)
{
    const MadeUpHit hit;
    const AskedNode grown{.type = "FRESNEL",
                          .inputs = {{"IOR", V3f(1.5f)}, {"Normal", V3f(0.0f, 0.0f, 1.4f)}}};
    EXPECT_FLOAT_EQ(grown("Fac", hit, seen_at(0.0)).x, fresnel_dielectric(1.4f, 1.5f).reflectance);
    EXPECT_GT(grown("Fac", hit, seen_at(0.0)).x, 0.045f);
}

TEST(LayerWeightNode, facing_is_a_power_of_the_cosine)
{
    const MadeUpHit hit;
    const auto facing = [&](float blend, double angle_deg) {
        const AskedNode node{.type = "LAYER_WEIGHT", .inputs = {{"Blend", V3f(blend)}}};
        return node("Facing", hit, seen_at(angle_deg)).x;
    };
    EXPECT_NEAR(facing(0.5f, 60.0), 0.5f, 1e-6f);
    EXPECT_NEAR(facing(0.25f, 60.0), 1.0f - std::sqrt(0.5f), 1e-6f);
    EXPECT_NEAR(facing(0.75f, 60.0), 1.0f - 0.25f, 1e-6f);
    EXPECT_NEAR(facing(0.0f, 60.0), 0.0f, 1e-6f);
    EXPECT_NEAR(facing(1.0f, 60.0), 1.0f, 1e-6f);
    EXPECT_NEAR(facing(7.0f, 0.0), 0.0f, 1e-6f);
}

TEST(LayerWeightNode, fresnel_has_the_index_that_the_blend_leaves)
{
    const MadeUpHit hit;
    for (const bool backfacing : {false, true}) {
        const AskedNode node{.type = "LAYER_WEIGHT", .inputs = {{"Blend", V3f(0.25f)}}};
        const float ior = backfacing ? 0.75f : 1.0f / 0.75f;
        EXPECT_FLOAT_EQ(node("Fresnel", hit, seen_at(30.0, backfacing)).x,
                        fresnel_dielectric(direction_at(30.0).z, ior).reflectance);
    }
}

TEST(WireframeNode, pixels_on_a_slant_are_as_wide_as_two_steps_on_average)
{
    MadeUpHit hit;
    // Along one of the steps: it is foreshortened to half, and the other not at all.
    const ShadingPoint point{
        .wo = direction_at(60.0, -45.0), .ng = up, .ns = up, .footprint = 0.01f};
    const auto is_wire = [&](float to_edge) {
        hit.to_edge = to_edge;
        return AskedNode{.type = "WIREFRAME",
                         .options = {{"use_pixel_size", 1.0}},
                         .inputs = {{"Size", V3f(2.0f)}}}("Fac", hit, point)
                   .x == 1.0f;
    };
    EXPECT_TRUE(is_wire(0.0074f));
    EXPECT_FALSE(is_wire(0.0076f));
}

TEST(WireframeNode, is_as_wide_as_it_says_over_both_triangles_of_an_edge)
{
    MadeUpHit hit;
    const auto is_wire = [&](float to_edge, bool in_pixels, float size = 2.0f) {
        hit.to_edge = to_edge;
        ShadingPoint point = seen_at(0.0);
        point.footprint = 0.01f;
        return AskedNode{.type = "WIREFRAME",
                         .options = {{"use_pixel_size", in_pixels ? 1.0 : 0.0}},
                         .inputs = {{"Size", V3f(size)}}}("Fac", hit, point)
                   .x == 1.0f;
    };
    EXPECT_TRUE(is_wire(0.99f, false, -2.0f)) << "a width has no sign";
    EXPECT_TRUE(is_wire(0.99f, false));
    EXPECT_FALSE(is_wire(1.01f, false));
    EXPECT_TRUE(is_wire(0.0099f, true));
    EXPECT_FALSE(is_wire(0.0101f, true));
}

}  // namespace
}  // namespace eye_render
