// Pictures on surfaces and around the scene: where they are looked up, by closed forms. What
// Cycles shows of them is tested in tests/scene/test_nodes_beside_cycles.cpp.

#include "asked_node.h"
#include "scattering.h"
#include "shading/picture_coordinates.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

using test::AskedNode;
using test::direction_at;
using test::MadeUpHit;
using test::up;

constexpr float rounding = 1e-6f;
const ShadingPoint seen{.wo = direction_at(30.0), .ng = up, .ns = up};

// A hit whose texture tells where it is asked, and which it is.
MadeUpHit telling_hit()
{
    MadeUpHit hit;
    hit.picture = [](int texture, const V2f& uv) {
        return Color4f(uv.x, uv.y, static_cast<float>(texture), 0.5f);
    };
    return hit;
}

V3f looked_up(std::map<std::string, NodeOptions::Value> options,
              const V3f& place,
              const ShadingPoint& point = seen)
{
    options.try_emplace("texture", 0.0);
    return AskedNode{.type = "TEX_IMAGE",
                     .options = std::move(options),
                     .inputs = {{"Vector", place}}}("Color", telling_hit(), point);
}

TEST(ImageNode, lies_flat_by_x_and_y)
{
    EXPECT_EQ(looked_up({}, {0.25f, 0.75f, 9.0f}), V3f(0.25f, 0.75f, 0.0f));
}

TEST(ImageNode, wraps_a_sphere_by_longitude_and_latitude)
{
    const auto at = [](const V3f& from_middle) {
        return looked_up({{"projection", "SPHERE"}}, V3f(0.5f) + from_middle * 0.5f);
    };
    // The seam is along -Y; u grows with the sun, seen from above.
    EXPECT_LT((at({0, 1, 0}) - V3f(0.5f, 0.5f, 0)).length(), rounding);
    EXPECT_LT((at({1, 0, 0}) - V3f(0.25f, 0.5f, 0)).length(), rounding);
    EXPECT_LT((at({-1, 0, 0}) - V3f(0.75f, 0.5f, 0)).length(), rounding);
    EXPECT_LT((at({0, 0.1f, 0.1f}) - V3f(0.5f, 0.75f, 0)).length(), rounding);
    EXPECT_LT((at({0, 0, 1}) - V3f(0, 1, 0)).length(), rounding);
    EXPECT_EQ(at({0, 0, 0}), V3f(0.0f));
}

TEST(ImageNode, wraps_a_tube_whose_height_is_v)
{
    const auto at = [](const V3f& from_middle) {
        return looked_up({{"projection", "TUBE"}}, V3f(0.5f) + from_middle * 0.5f);
    };
    EXPECT_LT((at({0, 0.2f, 0.5f}) - V3f(0.5f, 0.75f, 0)).length(), rounding);
    EXPECT_LT((at({1, 0, -1}) - V3f(0.25f, 0, 0)).length(), rounding);
    EXPECT_EQ(at({0, 0, 1}), V3f(0.0f)) << "on the axis there is no side";
}

TEST(ImageNode, is_mirrored_on_no_side_of_a_box)
{
    const V3f place(0.1f, 0.2f, 0.3f);
    const auto on_side = [&](const V3f& normal) {
        ShadingPoint point = seen;
        point.ns = normal;
        return looked_up({{"projection", "BOX"}}, place, point);
    };
    EXPECT_LT((on_side({1, 0, 0}) - V3f(0.2f, 0.3f, 0)).length(), rounding);
    EXPECT_LT((on_side({-1, 0, 0}) - V3f(0.8f, 0.3f, 0)).length(), rounding);
    EXPECT_LT((on_side({0, 1, 0}) - V3f(0.9f, 0.3f, 0)).length(), rounding);
    EXPECT_LT((on_side({0, -1, 0}) - V3f(0.1f, 0.3f, 0)).length(), rounding);
    EXPECT_LT((on_side({0, 0, 1}) - V3f(0.8f, 0.1f, 0)).length(), rounding);
    EXPECT_LT((on_side({0, 0, -1}) - V3f(0.2f, 0.1f, 0)).length(), rounding);
}

TEST(ImageNode, sides_of_a_box_are_the_objects_own)
{
    MadeUpHit hit = telling_hit();
    hit.facts.world_from_object.setEulerAngles(V3f(0.0f, 0.0f, float(pi) / 2.0f));
    ShadingPoint point = seen;
    point.ns = V3f(0, 1, 0);  // the object's own +X side, turned to +Y
    const AskedNode node{.type = "TEX_IMAGE",
                         .options = {{"texture", 0.0}, {"projection", "BOX"}},
                         .inputs = {{"Vector", V3f(0.1f, 0.2f, 0.3f)}}};
    EXPECT_LT((node("Color", hit, point) - V3f(0.2f, 0.3f, 0)).length(), rounding);
}

TEST(ImageNode, blends_the_sides_of_a_box_near_their_edges)
{
    const V3f place(0.1f, 0.2f, 0.3f);
    const auto on = [&](const V3f& normal, double blend) {
        ShadingPoint point = seen;
        point.ns = normal.normalized();
        return looked_up({{"projection", "BOX"}, {"projection_blend", blend}}, place, point);
    };
    const V3f on_x(0.2f, 0.3f, 0);
    const V3f on_y(0.9f, 0.3f, 0);
    const V3f on_z(0.8f, 0.1f, 0);
    EXPECT_LT((on({1, 1, 0}, 0.5) - (on_x + on_y) * 0.5f).length(), rounding) << "the edge";
    EXPECT_LT((on({1, 1, 1}, 0.5) - (on_x + on_y + on_z) / 3.0f).length(), rounding);
    // Shares of 0.6 and 0.4 of the normal: 0.6 is 0.35 into a blend from 0.25 to 0.75.
    EXPECT_LT((on({0.6f, 0.4f, 0}, 0.5) - (on_x * 0.7f + on_y * 0.3f)).length(), rounding);
    EXPECT_LT((on({0.8f, 0.2f, 0}, 0.5) - on_x).length(), rounding) << "beyond it";
    EXPECT_LT((on({1, 1, 0}, 0.0) - on_x).length(), rounding) << "a tie goes to x";
}

TEST(ImageNode, weights_of_a_box_are_shares_of_one)
{
    for (float blend : {0.0f, 0.1f, 0.5f, 1.0f}) {
        test::for_each_direction(24, 48, [&](const V3f& n, double /*solid_angle*/) {
            const V3f w = box_weights(n, blend);
            EXPECT_NEAR(w.x + w.y + w.z, 1.0f, 1e-5f) << n << " " << blend;
            EXPECT_GE(std::min({w.x, w.y, w.z}), -1e-6f) << n << " " << blend;
        });
    }
}

TEST(ImageNode, tiles_lie_beside_and_above_each_other_and_missing_ones_are_magenta)
{
    const std::map<std::string, NodeOptions::Value> tiles{
        {"tiles", std::vector<float>{1001, 4, 1002, 5, 1011, 6}}};
    EXPECT_LT((looked_up(tiles, {0.25f, 0.5f, 0}) - V3f(0.25f, 0.5f, 4)).length(), rounding);
    EXPECT_LT((looked_up(tiles, {1.25f, 0.5f, 0}) - V3f(0.25f, 0.5f, 5)).length(), rounding);
    EXPECT_LT((looked_up(tiles, {0.25f, 1.5f, 0}) - V3f(0.25f, 0.5f, 6)).length(), rounding);
    for (const V3f& nowhere : {V3f(1.5f, 1.5f, 0), V3f(-1.5f, 0.5f, 0), V3f(0.5f, -1.5f, 0),
                               V3f(10.5f, 0.5f, 0), V3f(1e20f, 0.5f, 0), V3f(0.5f, 1e20f, 0)}) {
        EXPECT_EQ(looked_up(tiles, nowhere), V3f(1.0f, 0.0f, 1.0f)) << nowhere;
    }
}

TEST(ImageNode, colour_is_straight_only_for_those_who_ask_for_alpha)
{
    for (const bool asks_alpha : {false, true}) {
        test::GraphTrial trial;
        const std::size_t image = trial.add("TEX_IMAGE", {{"texture", 1.0}});
        const std::size_t light = trial.add("EMISSION");
        trial.link(light, "Color", image, "Color");
        if (asks_alpha) {
            trial.link(light, "Strength", image, "Alpha");
        }
        const ShaderProgram program = trial.surface(light, "Emission");
        const MadeUpHit hit = telling_hit();
        const PathState path;
        static_cast<void>(program.emission({.point = seen, .attributes = hit, .path = path}));
        EXPECT_EQ(hit.asked_alpha, asks_alpha ? TextureAlpha::Straight : TextureAlpha::Associated);
    }
}

V3f around(const char* projection, const V3f& direction)
{
    return AskedNode{.type = "TEX_ENVIRONMENT",
                     .options = {{"texture", 2.0}, {"projection", projection}},
                     .inputs = {{"Vector", direction}}}("Color", telling_hit(), seen);
}

TEST(EnvironmentNode, is_centred_along_x_and_upright)
{
    for (const float length : {1.0f, 7.0f}) {
        const auto at = [&](const V3f& d) { return around("EQUIRECTANGULAR", d * length); };
        EXPECT_LT((at({1, 0, 0}) - V3f(0.5f, 0.5f, 2)).length(), rounding);
        EXPECT_LT((at({0, 1, 0}) - V3f(0.25f, 0.5f, 2)).length(), rounding);
        EXPECT_LT((at({0, -1, 0}) - V3f(0.75f, 0.5f, 2)).length(), rounding);
        EXPECT_LT((at({1, 0, 1}) - V3f(0.5f, 0.75f, 2)).length(), rounding);
        EXPECT_NEAR(at({0, 0, -1}).y, 0.0f, rounding);
    }
}

TEST(EnvironmentNode, mirror_ball_shows_what_its_surface_reflects)
{
    for (const float length : {1.0f, 7.0f}) {
        // Photographed along +Y: the middle shows what is behind the camera, the ball's normal at
        // (x, z) of the picture mirrors the view to the direction.
        for (const V3f& n : {V3f(0, -1, 0), V3f(0.6f, -0.8f, 0), V3f(0.36f, -0.8f, -0.48f)}) {
            const V3f view(0, 1, 0);
            const V3f mirrored = view - n * (2.0f * n.dot(view));
            const V3f found = around("MIRROR_BALL", mirrored * length);
            EXPECT_LT((found - V3f(0.5f + 0.5f * n.x, 0.5f + 0.5f * n.z, 2)).length(), rounding)
                << n;
        }
    }
}

}  // namespace
}  // namespace eye_render
