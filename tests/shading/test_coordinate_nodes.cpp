// Nodes that tell where the hit is. What Cycles makes of them on meshes is tested in
// tests/scene/test_nodes_beside_cycles.cpp.

#include "asked_node.h"
#include "scattering.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::AskedNode;
using test::direction_at;
using test::MadeUpHit;
using test::up;

const ShadingPoint seen{.wo = direction_at(30.0), .ng = up, .ns = up};
constexpr float rounding = 1e-6f;

TEST(TextureCoordinateNode, tells_the_place_in_every_space)
{
    MadeUpHit hit;
    hit.p_world = V3f(1, 2, -4);
    hit.p_object = V3f(4, 5, 6);
    hit.p_generated = V3f(0.1f, 0.2f, 0.3f);
    hit.uv_value = V2f(0.7f, 0.8f);
    const AskedNode node{.type = "TEX_COORD"};
    EXPECT_EQ(node("Generated", hit, seen), hit.p_generated);
    EXPECT_EQ(node("Object", hit, seen), hit.p_object);
    EXPECT_EQ(node("UV", hit, seen), V3f(0.7f, 0.8f, 0.0f));
    EXPECT_EQ(node("Camera", hit, seen), V3f(1, 2, 4));
    EXPECT_EQ(hit.questions, 5) << "one each, and the camera's frame";
}

TEST(TextureCoordinateNode, normal_is_the_objects_own)
{
    MadeUpHit hit;
    // Stretched twice along x: a world slope of 1/2 is one of 1 in the object.
    hit.facts.world_from_object.setScale(V3f(2, 1, 1));
    ShadingPoint point = seen;
    point.ns = V3f(1, 0, 2).normalized();
    const V3f normal = AskedNode{.type = "TEX_COORD"}("Normal", hit, point);
    EXPECT_LT((normal - V3f(1, 0, 1).normalized()).length(), rounding);
}

TEST(TextureCoordinateNode, window_is_0_to_1_over_the_picture)
{
    MadeUpHit hit;
    hit.camera.slope_first = V2f(-0.5f, -0.25f);
    hit.camera.slope_last = V2f(1.5f, 0.25f);
    const AskedNode node{.type = "TEX_COORD"};
    const auto window = [&](const V3f& p) {
        hit.p_world = p;
        return node("Window", hit, seen);
    };
    EXPECT_LT((window({-2, -1, -4}) - V3f(0, 0, 0)).length(), rounding);
    EXPECT_LT((window({6, 1, -4}) - V3f(1, 1, 0)).length(), rounding);
    EXPECT_LT((window({2, 0, -4}) - V3f(0.5f, 0.5f, 0)).length(), rounding);
    EXPECT_LT((window({-2, 0, 4}) - V3f(0.5f, 0.5f, 0)).length(), rounding) << "behind";
    EXPECT_EQ(window({1, 1, 0}), V3f(0.0f)) << "nowhere";
}

TEST(TextureCoordinateNode, reflection_is_where_a_mirror_looks)
{
    const MadeUpHit hit;
    const V3f mirrored = AskedNode{.type = "TEX_COORD"}("Reflection", hit, seen);
    EXPECT_LT((mirrored - direction_at(30.0, 180.0)).length(), rounding);
}

TEST(TextureCoordinateNode, another_object_may_lend_its_coordinates)
{
    MadeUpHit hit;
    hit.p_world = V3f(1, 2, 3);
    hit.p_object = V3f(9.0f);
    // Rows, for column vectors: twice x, and 10 added to y.
    const std::vector<float> matrix{2, 0, 0, 0, 0, 1, 0, 10, 0, 0, 1, 0, 0, 0, 0, 1};
    const AskedNode node{.type = "TEX_COORD", .options = {{"object_from_world", matrix}}};
    EXPECT_EQ(node("Object", hit, seen), V3f(2, 12, 3));
    const AskedNode broken{.type = "TEX_COORD",
                           .options = {{"object_from_world", std::vector<float>(12, 1.0f)}}};
    EXPECT_THROW(static_cast<void>(broken("Object", hit, seen)), std::invalid_argument);
}

TEST(GeometryNode, tells_the_surface_as_the_viewer_meets_it)
{
    MadeUpHit hit;
    hit.p_world = V3f(1, 2, 3);
    hit.weights = V2f(0.25f, 0.125f);
    const AskedNode node{.type = "NEW_GEOMETRY"};
    ShadingPoint point = seen;
    point.ns = direction_at(10.0);
    EXPECT_EQ(node("Position", hit, point), hit.p_world);
    EXPECT_EQ(node("Normal", hit, point), point.ns);
    EXPECT_EQ(node("True Normal", hit, point), up);
    EXPECT_EQ(node("Incoming", hit, point), point.wo);
    EXPECT_EQ(node("Backfacing", hit, point).x, 0.0f);
    point.backfacing = true;
    EXPECT_EQ(node("Backfacing", hit, point).x, 1.0f);
    // The weights of the first two corners, as Cycles counts.
    EXPECT_EQ(node("Parametric", hit, point), V3f(0.625f, 0.25f, 0.0f));
}

TEST(TangentNode, radial_tangents_run_around_their_axis)
{
    MadeUpHit hit;
    const auto tangent = [&](const char* axis, const V3f& from_middle, const V3f& normal) {
        hit.p_generated = V3f(0.5f) + from_middle;
        ShadingPoint point = seen;
        point.ns = normal;
        return AskedNode{.type = "TANGENT", .options = {{"axis", axis}}}("Tangent", hit, point);
    };
    EXPECT_LT((tangent("Z", {0.3f, 0, 0}, up) - V3f(0, 1, 0)).length(), rounding);
    EXPECT_LT((tangent("Z", {0, 0.3f, 0}, up) - V3f(-1, 0, 0)).length(), rounding);
    EXPECT_LT((tangent("X", {0, 0.3f, 0}, {1, 0, 0}) - V3f(0, 0, 1)).length(), rounding);
    EXPECT_LT((tangent("Y", {0.3f, 0, 0}, {0, 1, 0}) - V3f(0, 0, 1)).length(), rounding);
    // Turned into the surface, and unit.
    const V3f tilted = tangent("Z", {0.3f, 0, 0}, V3f(0, 0.6f, 0.8f));
    EXPECT_LT((tilted - V3f(0, 0.8f, -0.6f)).length(), rounding);
    EXPECT_EQ(tangent("Z", {0, 0, 0}, up), V3f(0.0f)) << "on the axis there is none";
    // The node Geometry has that around z.
    hit.p_generated = V3f(0.8f, 0.5f, 0.5f);
    EXPECT_LT((AskedNode{.type = "NEW_GEOMETRY"}("Tangent", hit, seen) - V3f(0, 1, 0)).length(),
              rounding);
}

TEST(TangentNode, that_of_a_uv_map_is_turned_into_the_surface)
{
    MadeUpHit hit;
    hit.frame.tangent = V3f(0.8f, 0.0f, 0.6f);
    const AskedNode node{.type = "TANGENT", .options = {{"direction_type", "UV_MAP"}}};
    EXPECT_LT((node("Tangent", hit, seen) - V3f(1, 0, 0)).length(), rounding);
    MadeUpHit smoothed = hit;
    smoothed.smoothed_tangent = {.value = Color4f(0.0f, -3.0f, 0.0f, 1.0f), .exists = true};
    EXPECT_LT((node("Tangent", smoothed, seen) - V3f(0, -1, 0)).length(), rounding);
    hit.frame.tangent = V3f(0.0f);
    EXPECT_EQ(node("Tangent", hit, seen), V3f(0.0f));
}

TEST(AttributeNode, factor_is_the_mean_and_what_is_missing_is_opaque_black)
{
    MadeUpHit hit;
    hit.layer.value = Color4f(0.3f, 0.6f, 0.9f, 0.5f);
    const AskedNode node{.type = "ATTRIBUTE", .options = {{"attribute_name", "a"}}};
    EXPECT_EQ(node("Color", hit, seen), V3f(0.3f, 0.6f, 0.9f));
    EXPECT_EQ(node("Vector", hit, seen), V3f(0.3f, 0.6f, 0.9f));
    EXPECT_FLOAT_EQ(node("Fac", hit, seen).x, 0.6f);
    EXPECT_EQ(node("Alpha", hit, seen).x, 0.5f);
    hit.layer = {};
    EXPECT_EQ(node("Color", hit, seen), V3f(0.0f));
    EXPECT_EQ(node("Alpha", hit, seen).x, 1.0f);
}

TEST(ColorAttributeNode, what_is_missing_is_clear)
{
    MadeUpHit hit;
    hit.layer.value = Color4f(0.3f, 0.6f, 0.9f, 0.5f);
    const AskedNode node{.type = "VERTEX_COLOR", .options = {{"layer_name", "a"}}};
    EXPECT_EQ(node("Color", hit, seen), V3f(0.3f, 0.6f, 0.9f));
    EXPECT_EQ(node("Alpha", hit, seen).x, 0.5f);
    hit.layer = {};
    EXPECT_EQ(node("Alpha", hit, seen).x, 0.0f);
}

}  // namespace
}  // namespace eye_render
