// A built scene: light sampling and its densities, and scenes far from the origin.

#include "scene/scene.h"

#include "base/sobol.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

Material shining(float radiance)
{
    return plain_material("EMISSION", {{"Color", V3f(1.0f)}, {"Strength", V3f(radiance)}});
}

SceneData shining_square(const V3d& at)
{
    SceneData data;
    Mesh mesh;
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    data.geometries.push_back(mesh);
    data.materials.push_back(shining(3.0f));
    M44d world_from_object;
    world_from_object.setTranslation(at);
    data.instances.push_back(
        {.geometry = 0, .world_from_object = world_from_object, .materials = {0}});
    return data;
}

TEST(Scene, sampled_emitter_is_met_by_a_ray_with_the_same_density)
{
    SceneData data = shining_square(V3d(0, 0, -2));
    data.world = plain_material("BACKGROUND", {{"Color", V3f(0.5f)}});
    const Scene scene(data, V3d(0.0));
    const V3f p(0.3f, -0.2f, 0.0f);
    LitPoint point;
    scene.weigh_lights(p, V3f(0, 0, -1), point);
    int emitters = 0;
    for (std::uint32_t i = 0; i < 256; ++i) {
        const auto u = sobol_4d(1, i, 0);
        const auto light = scene.sample_light(point, u[2], V2f(u[0], u[1]));
        ASSERT_TRUE(light);
        const auto hit = scene.intersect({.origin = p, .direction = light->wi});
        if (std::isfinite(light->distance)) {
            ++emitters;
            ASSERT_TRUE(hit);
            EXPECT_NEAR(scene.emitter_pdf(*hit, point), light->pdf, 1e-3f * light->pdf);
            EXPECT_EQ(light->radiance, Color3f(3.0f));
            EXPECT_NEAR(hit->t, light->distance, 1e-3f);
        } else {
            EXPECT_NEAR(scene.environment_pdf(light->wi, point), light->pdf, 1e-4f * light->pdf);
        }
    }
    EXPECT_GT(emitters, 30);
    EXPECT_LT(emitters, 226);
}

TEST(Scene, sampled_lights_estimate_the_irradiance_of_a_square)
{
    const SceneData data = shining_square(V3d(0, 0, -2));
    const Scene scene(data, V3d(0.0));
    const V3f n(0, 0, -1);
    LitPoint point;
    scene.weigh_lights(V3f(0.0f), n, point);
    double sum = 0.0;
    constexpr std::uint32_t count = 1 << 14;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto u = sobol_4d(2, i, 0);
        const auto light = scene.sample_light(point, u[2], V2f(u[0], u[1]));
        ASSERT_TRUE(light);
        sum += static_cast<double>(light->radiance.x * n.dot(light->wi) / light->pdf) / count;
    }
    // On the axis of a square of half width a at distance c, four corner rectangles (Howell B-4):
    // E = L 4 x / sqrt(1 + x^2) atan(x / sqrt(1 + x^2)), x = a / c.
    const double x = 0.5;
    const double s = std::sqrt(1 + x * x);
    EXPECT_NEAR(sum, 3.0 * 4.0 * x / s * std::atan(x / s), 0.005);
}

TEST(Scene, ten_thousand_kilometres_away_is_like_at_the_origin)
{
    const V3d eye(1e7, -2e7, 1e7);
    const SceneData near_data = shining_square(V3d(0.1, 0.2, -2));
    const SceneData far_data = shining_square(V3d(0.1, 0.2, -2) + eye);
    const Scene near(near_data, V3d(0.0));
    const Scene far(far_data, eye);
    const Ray ray{.direction = V3f(0.2f, 0.1f, -1.0f).normalized()};
    const auto a = near.intersect(ray);
    const auto b = far.intersect(ray);
    ASSERT_TRUE(a && b);
    // A double holds 2e7 to 4e-9.
    EXPECT_LT((a->p_world - b->p_world).length(), 1e-6f);
}

TEST(Scene, scene_without_anything_is_dark_and_empty)
{
    const SceneData data;
    const Scene scene(data, V3d(0.0));
    EXPECT_FALSE(scene.intersect({}));
    EXPECT_EQ(scene.background(V3f(0, 0, 1), {}), Color3f(0.0f));
    LitPoint point;
    scene.weigh_lights(V3f(0.0f), V3f(0, 0, 1), point);
    EXPECT_FALSE(scene.sample_light(point, 0.5f, V2f(0.5f)));
    EXPECT_EQ(scene.transmittance({}), Color3f(1.0f));
}

}  // namespace
}  // namespace eye_render
