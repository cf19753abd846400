// Clouds of balls: as data, and rays against balls in closed form.

#include "scene/point_attributes.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

Points two_balls()
{
    Points points;
    points.name = "two";
    points.points = {{V3f(0.0f, 0.0f, -5.0f), 1.0f}, {V3f(3.0f, 0.0f, -5.0f), 0.5f}};
    return points;
}

SceneData placed(Points points, const std::vector<M44d>& places)
{
    SceneData data;
    data.geometries.emplace_back(std::move(points));
    for (const M44d& place : places) {
        data.instances.push_back({.geometry = 0, .world_from_object = place, .materials = {}});
    }
    return data;
}

TEST(Points, rays_meet_balls_where_the_quadratic_says)
{
    const SceneData data = placed(two_balls(), {M44d()});
    const Scene scene(data, V3d(0.0));
    for (const float x : {-0.9f, -0.2f, 0.0f, 0.5f}) {
        const auto hit = scene.intersect({.origin = V3f(x, 0.0f, 0.0f)});
        ASSERT_TRUE(hit) << x;
        const float depth = std::sqrt(1.0f - x * x);
        EXPECT_NEAR(hit->t, 5.0f - depth, 1e-5f) << x;
        EXPECT_LT((hit->p_world - V3f(x, 0.0f, -5.0f + depth)).length(), 1e-5f) << x;
        EXPECT_LT((hit->point.ng - V3f(x, 0.0f, depth)).length(), 1e-5f) << x;
        EXPECT_EQ(hit->primitive, 0u);
    }
    const auto other = scene.intersect({.origin = V3f(3.2f, 0.0f, 0.0f)});
    ASSERT_TRUE(other);
    EXPECT_EQ(other->primitive, 1u);
    EXPECT_FALSE(scene.intersect({.origin = V3f(1.5f, 0.0f, 0.0f)}));
}

TEST(Points, a_stretched_prototype_makes_ellipsoids)
{
    M44d stretched;
    stretched.setScale(V3d(2.0, 1.0, 1.0));
    M44d elsewhere;
    elsewhere.setTranslation(V3d(0.0, 50.0, 0.0));
    const SceneData data = placed(two_balls(), {stretched, elsewhere});
    const Scene scene(data, V3d(0.0));
    const auto hit = scene.intersect({.origin = V3f(1.0f, 0.0f, 0.0f)});
    ASSERT_TRUE(hit);
    // On x = 2 sin, z = cos of 30 degrees the normal goes as (sin / 2, cos).
    const float cosine = std::sqrt(0.75f);
    EXPECT_NEAR(hit->p_world.z, -5.0f + cosine, 1e-5f);
    EXPECT_LT((hit->point.ng - V3f(0.25f, 0.0f, cosine).normalized()).length(), 1e-5f);
}

TEST(Points, a_ray_that_leaves_a_ball_does_not_meet_it_again)
{
    const SceneData data = placed(two_balls(), {M44d()});
    const Scene scene(data, V3d(0.0));
    const auto hit = scene.intersect({.origin = V3f(-0.5f, 0.1f, 0.0f)});
    ASSERT_TRUE(hit);
    for (int i = 0; i < 100; ++i) {
        const float angle = 0.0628f * static_cast<float>(i);
        const V3f wi(0.0f, std::cos(angle), std::sin(angle));
        EXPECT_FALSE(scene.intersect({.origin = hit->origin_towards(wi), .direction = wi})) << wi;
    }
}

TEST(Points, a_ball_tells_where_it_is)
{
    Points points = two_balls();
    points.attributes = {{"Col", {{0.1f, 0.2f, 0.3f, 1.0f}, {0.4f, 0.5f, 0.6f, 1.0f}}}};
    SceneData data = placed(std::move(points), {M44d()});
    data.attribute_names = {"Col"};
    const V3d eye(1.0, 2.0, 3.0);
    const Scene scene(data, eye);
    const auto hit = scene.intersect({.origin = V3f(V3d(3.0, 0.0, 0.0) - eye)});
    ASSERT_TRUE(hit);
    SceneFrame frame;
    frame.eye_position_world = eye;
    const PointAttributes at(*hit, hit->p_world, hit->placement->pose, frame);
    const auto point = at.point();
    ASSERT_TRUE(point);
    EXPECT_LT((point->position_world - V3f(3.0f, 0.0f, -5.0f)).length(), 1e-5f);
    EXPECT_NEAR(point->radius, 0.5f, 1e-6f);
    EXPECT_FLOAT_EQ(at.attribute(0).value.g, 0.5f);
    EXPECT_FALSE(at.strand());
}

TEST(Points, broken_ones_are_refused_or_left_out)
{
    Points negative = two_balls();
    negative.points[1].radius = -0.1f;
    EXPECT_THROW(validate(negative), std::invalid_argument);
    Points short_layer = two_balls();
    short_layer.attributes = {{"Col", {}}};
    EXPECT_THROW(validate(short_layer), std::invalid_argument);
    Points infinite = two_balls();
    infinite.points[0].center.y = std::numeric_limits<float>::infinity();
    EXPECT_EQ(drop_broken_points(infinite), 1u);
    ASSERT_EQ(infinite.points.size(), 1u);
    EXPECT_FLOAT_EQ(infinite.points[0].radius, 0.5f);
}

}  // namespace
}  // namespace eye_render
