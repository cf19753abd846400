// Rays that nodes send from a hit: what they meet, in a corner of two walls.

#include "scene/scene_probe.h"

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace eye_render {
namespace {

// A floor at z = 0 around the origin.
Mesh floor_mesh()
{
    Mesh mesh;
    mesh.positions = {{-5, -5, 0}, {5, -5, 0}, {5, 5, 0}, {-5, 5, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

// The floor, and an upright wall at x = 1 as another object.
SceneData corner()
{
    SceneData data;
    data.geometries.emplace_back(floor_mesh());
    data.materials.push_back(plain_material("BSDF_DIFFUSE", {}));
    M44d upright;
    upright.setAxisAngle(V3d(0, 1, 0), 0.5 * M_PI);
    upright *= M44d().setTranslation(V3d(1, 0, 0));
    data.instances.push_back({.geometry = 0, .world_from_object = {}, .materials = {0}});
    data.instances.push_back({.geometry = 0, .world_from_object = upright, .materials = {0}});
    return data;
}

std::optional<SurfaceHit> floor_hit(const Scene& scene, float x = 0.0f)
{
    return scene.intersect({.origin = V3f(x, 0.1f, 3.0f), .direction = V3f(0, 0, -1)});
}

TEST(SceneProbe, is_blocked_by_what_stands_near_enough)
{
    const SceneData data = corner();
    const Scene scene(data, V3d(0.0));
    const auto hit = floor_hit(scene);
    ASSERT_TRUE(hit);
    const SceneProbe probe(scene, *hit);
    const V3f to_wall = V3f(1, 0, 1).normalized();
    const float distance = std::sqrt(2.0f);
    EXPECT_TRUE(probe.is_blocked(to_wall, 1.01f * distance, false));
    EXPECT_FALSE(probe.is_blocked(to_wall, 0.99f * distance, false));
    EXPECT_FALSE(probe.is_blocked(V3f(-1, 0, 1).normalized(), 100.0f, false));
    EXPECT_FALSE(probe.is_blocked(to_wall, 100.0f, true)) << "the wall is another object";
    // From a surface into itself nothing is met at the start.
    EXPECT_FALSE(probe.is_blocked(V3f(0, 0, -1), 100.0f, true));
}

TEST(SceneProbe, what_throws_no_shadow_blocks_nothing)
{
    SceneData data = corner();
    data.instances[1].visibility.to_shadow = false;
    const Scene scene(data, V3d(0.0));
    const auto hit = floor_hit(scene);
    ASSERT_TRUE(hit);
    EXPECT_FALSE(SceneProbe(scene, *hit).is_blocked(V3f(1, 0, 0.2f).normalized(), 10.0f, false));
}

TEST(SceneProbe, crosses_its_own_object_and_passes_by_others)
{
    SceneData data = corner();
    // One object of two floors, the upper one seen from below.
    Mesh& mesh = std::get<Mesh>(data.geometries[0]);
    for (int i = 0; i < 4; ++i) {
        mesh.positions.push_back(mesh.positions[std::size_t(i)] + V3f(0, 0, -1));
    }
    mesh.triangles.push_back({4, 6, 5});
    mesh.triangles.push_back({4, 7, 6});
    const Scene scene(data, V3d(0.0));
    const auto hit = floor_hit(scene, 0.5f);
    ASSERT_TRUE(hit);
    std::vector<SurfaceProbe::Crossing> met;
    SceneProbe(scene, *hit)
        .cross_own_object(
            V3f(0, 0, 2), V3f(0.2f, 0, -1).normalized(), 4.0f,
            [&](const SurfaceProbe::Crossing& crossing) { met.push_back(crossing); });
    ASSERT_EQ(met.size(), 2u) << "the wall between is another object";
    EXPECT_NEAR(met[0].from_hit.z, 0.0f, 1e-5f);
    EXPECT_NEAR(met[0].from_hit.x, 0.4f, 1e-5f);
    EXPECT_NEAR(met[0].ns.z, 1.0f, 1e-5f);
    EXPECT_NEAR(met[1].from_hit.z, -1.0f, 1e-5f);
    EXPECT_NEAR(met[1].ns.z, -1.0f, 1e-5f) << "on the mesh's own side";
}

TEST(SceneProbe, seeds_differ_from_hit_to_hit_and_not_from_time_to_time)
{
    const SceneData data = corner();
    const Scene scene(data, V3d(0.0));
    std::set<std::uint64_t> seeds;
    for (int i = 0; i < 100; ++i) {
        const auto hit = floor_hit(scene, 1e-5f * float(i));
        ASSERT_TRUE(hit);
        EXPECT_EQ(SceneProbe(scene, *hit).seed(), SceneProbe(scene, *hit).seed());
        seeds.insert(SceneProbe(scene, *hit).seed());
    }
    EXPECT_EQ(seeds.size(), 100u);
}

}  // namespace
}  // namespace eye_render
