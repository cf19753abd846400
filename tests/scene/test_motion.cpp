// Geometry while the shutter is open: places, turns and shapes at times between the known ones.

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace eye_render {
namespace {

Mesh square()
{
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-1, -1, -5}, {1, -1, -5}, {1, 1, -5}, {-1, 1, -5}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

M44d at(const V3d& place)
{
    M44d m;
    m.setTranslation(place);
    return m;
}

// About the z axis.
M44d turned(double degrees)
{
    M44d m;
    m.rotate(V3d(0.0, 0.0, degrees * std::numbers::pi / 180.0));
    return m;
}

SceneData moving(Geometry geometry, std::vector<M44d> motion)
{
    SceneData data;
    data.geometries.push_back(std::move(geometry));
    InstanceData instance{.geometry = 0,
                          .world_from_object = motion.empty() ? M44d() : motion[1],
                          .materials = {},
                          .motion = std::move(motion)};
    data.instances.push_back(std::move(instance));
    return data;
}

TEST(Motion, an_object_is_on_its_way_between_its_places)
{
    const SceneData data =
        moving(square(), {at({-4.0, 0.0, 0.0}), at({0.0, 0.0, 0.0}), at({2.0, 0.0, 0.0})});
    const Scene scene(data, V3d(0.0));
    for (const auto& [time, x] : std::vector<std::pair<float, float>>{
             {0.0f, -4.0f}, {0.25f, -2.0f}, {0.5f, 0.0f}, {0.75f, 1.0f}, {1.0f, 2.0f}}) {
        for (const float side : {-0.9f, 0.9f}) {
            const auto hit = scene.intersect({.origin = V3f(x + side, 0.0f, 0.0f), .time = time});
            ASSERT_TRUE(hit) << time;
            EXPECT_LT((hit->p_world - V3f(x + side, 0.0f, -5.0f)).length(), 1e-5f) << time;
            EXPECT_FLOAT_EQ(hit->time, time);
        }
        EXPECT_FALSE(scene.intersect({.origin = V3f(x + 1.1f, 0.0f, 0.0f), .time = time}));
    }
}

TEST(Motion, turns_are_even_and_keep_the_size)
{
    // An arm of length 3 along x.
    Mesh arm = square();
    for (V3f& p : arm.positions) {
        p.x = 3.0f + 0.1f * p.x;
        p.y *= 0.1f;
    }
    const SceneData data = moving(arm, {turned(0.0), turned(60.0), turned(120.0)});
    const Scene scene(data, V3d(0.0));
    for (const float time : {0.0f, 0.1f, 0.25f, 0.6f, 1.0f}) {
        const float angle = time * 120.0f * std::numbers::pi_v<float> / 180.0f;
        const V3f place(3.0f * std::cos(angle), 3.0f * std::sin(angle), 0.0f);
        const auto hit = scene.intersect({.origin = place, .time = time});
        ASSERT_TRUE(hit) << time;
        // Embree's arc cosine is good to 1e-3 of a step.
        EXPECT_LT((hit->p_world - place - V3f(0.0f, 0.0f, -5.0f)).length(), 1e-2f) << time;
    }
}

TEST(Motion, normals_turn_with_the_object)
{
    M44d tilt;
    tilt.rotate(V3d(0.0, 0.8, 0.0));
    M44d half;
    half.rotate(V3d(0.0, 0.4, 0.0));
    Mesh plate = square();
    for (V3f& p : plate.positions) {
        p.z = 0.0f;
    }
    const SceneData data = moving(plate, {M44d(), half, tilt});
    const Scene scene(data, V3d(0.0, 0.0, 5.0));
    const auto hit = scene.intersect({.time = 0.75f});
    ASSERT_TRUE(hit);
    EXPECT_LT((hit->point.ng - V3f(std::sin(0.6f), 0.0f, std::cos(0.6f))).length(), 1e-3f);
}

TEST(Motion, a_deforming_mesh_has_shape_and_normals_of_the_time)
{
    Mesh mesh = square();
    mesh.normal_domain = NormalDomain::PerVertex;
    mesh.normals.assign(4, V3f(0.0f, 0.0f, 1.0f));
    std::vector<V3f> later = mesh.positions;
    for (V3f& p : later) {
        p.z = -9.0f;
    }
    mesh.motion_positions = {mesh.positions, later};
    mesh.motion_normals = {mesh.normals, std::vector<V3f>(4, V3f(1.0f, 0.0f, 0.0f))};
    const SceneData data = moving(mesh, {});
    const Scene scene(data, V3d(0.0));
    for (const float time : {0.0f, 0.25f, 1.0f}) {
        const auto hit = scene.intersect({.origin = V3f(0.2f, 0.3f, 0.0f), .time = time});
        ASSERT_TRUE(hit) << time;
        EXPECT_NEAR(hit->p_world.z, -5.0f - 4.0f * time, 1e-5f);
        EXPECT_LT((hit->point.ns - V3f(time, 0.0f, 1.0f - time).normalized()).length(), 1e-5f);
    }
}

TEST(Motion, strands_and_balls_move_by_their_keys)
{
    Points points;
    points.points = {{V3f(0.0f, 0.0f, -5.0f), 0.5f}};
    points.motion = {{{V3f(-1.0f, 0.0f, -5.0f), 0.5f}}, {{V3f(1.0f, 0.0f, -5.0f), 0.5f}}};
    Curves curves;
    curves.first_keys = {0};
    curves.keys = {{V3f(0.0f, -2.0f, -5.0f), 0.5f}, {V3f(0.0f, 2.0f, -5.0f), 0.5f}};
    for (const float x : {-1.0f, 1.0f}) {
        curves.motion.push_back({{V3f(x, -2.0f, -5.0f), 0.5f}, {V3f(x, 2.0f, -5.0f), 0.5f}});
    }
    for (const Geometry& geometry : {Geometry(points), Geometry(curves)}) {
        const SceneData data = moving(geometry, {});
        const Scene scene(data, V3d(0.0));
        const auto hit = scene.intersect({.origin = V3f(0.5f, 0.0f, 0.0f), .time = 0.75f});
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 4.5f, 1e-4f);
        EXPECT_LT((hit->point.ng - V3f(0.0f, 0.0f, 1.0f)).length(), 1e-3f);
        EXPECT_FALSE(scene.intersect({.origin = V3f(0.5f, 0.0f, 0.0f), .time = 0.0f}));
    }
}

TEST(Motion, what_shines_is_sampled_where_it_is)
{
    Mesh deforming = square();
    for (const float x : {-3.0f, 3.0f}) {
        deforming.motion_positions.push_back(deforming.positions);
        for (V3f& p : deforming.motion_positions.back()) {
            p.x += x;
        }
    }
    const std::vector<M44d> places{at({-3.0, 0.0, 0.0}), at({0.0, 0.0, 0.0}), at({3.0, 0.0, 0.0})};
    for (const bool deforms : {false, true}) {
        SceneData data = deforms ? moving(deforming, {}) : moving(square(), places);
        data.materials.push_back(
            plain_material("EMISSION", {{"Color", V3f(1.0f)}, {"Strength", V3f(2.0f)}}));
        data.instances[0].materials = {0};
        const Scene scene(data, V3d(0.0));
        for (const float time : {0.0f, 0.3f, 0.5f, 1.0f}) {
            LitPoint point;
            point.time = time;
            scene.weigh_lights(V3f(0.0f), V3f(0, 0, -1), point);
            const auto light = scene.sample_light(point, 0.4, V2f(0.3f, 0.7f));
            ASSERT_TRUE(light) << time;
            EXPECT_EQ(light->radiance, Color3f(2.0f));
            const auto hit = scene.intersect({.direction = light->wi, .time = time});
            ASSERT_TRUE(hit) << time;
            EXPECT_NEAR(hit->p_world.x, 6.0f * (time - 0.5f), 1.0f);
            EXPECT_NEAR(scene.emitter_pdf(*hit, point), light->pdf, 1e-3f * light->pdf) << time;
        }
    }
}

TEST(Motion, a_lamp_is_sampled_and_met_where_it_is)
{
    SceneData data;
    const auto lamp_at = [](double x) {
        return LampPose{{.color = Color3f(1.0f), .radius = 0.5f}, at({x, 0.0, -5.0})};
    };
    data.lamps.push_back({.name = "lamp",
                          .settings = lamp_at(0.0).settings,
                          .world_from_light = lamp_at(0.0).world_from_light,
                          .motion = {lamp_at(-4.0), lamp_at(0.0), lamp_at(2.0)}});
    const Scene scene(data, V3d(0.0));
    for (const auto& [time, x] :
         std::vector<std::pair<float, float>>{{0.0f, -4.0f}, {0.25f, -2.0f}, {0.75f, 1.0f}}) {
        LitPoint point;
        point.time = time;
        scene.weigh_lights(V3f(0.0f), V3f(0, 0, -1), point);
        const auto light = scene.sample_light(point, 0.0, V2f(0.5f, 0.5f));
        ASSERT_TRUE(light) << time;
        const V3f middle(x, 0.0f, -5.0f);
        EXPECT_NEAR(light->wi.dot(middle.normalized()), 1.0f, 0.01f) << time;
        int met = 0;
        scene.visit_lamps(point, {.is_camera = false}, light->wi, 0.0f,
                          std::numeric_limits<float>::infinity(),
                          [&](const LampContribution& lamp) {
                              ++met;
                              const float pdf = scene.lamp_pdf(lamp, point);
                              EXPECT_NEAR(pdf, light->pdf, 1e-3f * light->pdf);
                          });
        EXPECT_EQ(met, 1) << time;
        scene.visit_lamps(point, {.is_camera = false}, V3f(0, 0, -1), 0.0f,
                          std::numeric_limits<float>::infinity(),
                          [&](const LampContribution&) { ADD_FAILURE() << time; });
    }
}

TEST(Motion, a_place_is_found_at_another_time)
{
    const SceneData data = moving(square(), {at({0.0, 0.0, 0.0}), turned(30.0), turned(60.0)});
    const Scene scene(data, V3d(0.0));
    const auto hit = scene.intersect({.direction = V3f(0.1f, 0.0f, -1.0f).normalized()});
    ASSERT_TRUE(hit);
    for (const float sign : {-1.0f, 1.0f}) {
        const float turn = sign * std::numbers::pi_v<float> / 6.0f;
        const V3f expected(0.5f * std::cos(turn), 0.5f * std::sin(turn), -5.0f);
        EXPECT_LT((scene.place_at(*hit, 0.5f + 0.5f * sign) - expected).length(), 1e-5f);
    }
    EXPECT_EQ(scene.place_at(*hit, 0.5f), hit->p_world);
}

}  // namespace
}  // namespace eye_render
