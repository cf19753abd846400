// Where rays met meshes: sides and normals, of mirrored, instanced and flattened objects as well.

#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

// A square in z = 0 facing +Z.
Mesh square()
{
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

SceneData one(const Mesh& mesh, const M44d& world_from_object)
{
    SceneData data;
    data.geometries.push_back(mesh);
    data.instances.push_back(
        {.geometry = 0, .world_from_object = world_from_object, .materials = {}});
    return data;
}

M44d at_two_metres(double scale_x)
{
    M44d m;
    m[0][0] = scale_x;
    m[3][2] = -2.0;
    return m;
}

TEST(SurfaceHit, turns_to_the_viewer_and_says_which_side_it_was)
{
    for (const double scale_x : {1.0, -1.0}) {
        const SceneData data = one(square(), at_two_metres(scale_x));
        const Scene scene(data, V3d(0.0));
        const auto front = scene.intersect({});
        ASSERT_TRUE(front);
        EXPECT_EQ(front->point.ng, V3f(0, 0, 1)) << scale_x;
        EXPECT_FALSE(front->point.backfacing) << "a mirrored object keeps its front";
        const auto back = scene.intersect({.origin = V3f(0, 0, -4), .direction = V3f(0, 0, 1)});
        ASSERT_TRUE(back);
        EXPECT_EQ(back->point.ng, V3f(0, 0, -1));
        EXPECT_TRUE(back->point.backfacing);
    }
}

TEST(SurfaceHit, flat_and_instanced_meshes_look_alike)
{
    Mesh mesh = square();
    mesh.normal_domain = NormalDomain::PerVertex;
    mesh.normals.assign(4, V3f(0.6f, 0.0f, 0.8f));
    const SceneData flat_data = one(mesh, at_two_metres(-0.5));
    SceneData instanced_data = one(mesh, at_two_metres(-0.5));
    M44d elsewhere;
    elsewhere.setTranslation(V3d(50, 0, 0));
    instanced_data.instances.push_back(
        {.geometry = 0, .world_from_object = elsewhere, .materials = {}});
    const Scene flat(flat_data, V3d(0.0));
    const Scene instanced(instanced_data, V3d(0.0));
    const Ray ray{.direction = V3f(0.1f, 0.2f, -1.0f).normalized()};
    const auto a = flat.intersect(ray);
    const auto b = instanced.intersect(ray);
    ASSERT_TRUE(a && b);
    EXPECT_LT((a->p_world - b->p_world).length(), 1e-6f);
    EXPECT_LT((a->point.ns - b->point.ns).length(), 1e-6f);
    EXPECT_LT((a->point.ng - b->point.ng).length(), 1e-6f);
}

TEST(SurfaceHit, flattened_instances_neither_crash_nor_hide_the_rest)
{
    SceneData data = one(square(), at_two_metres(1.0));
    for (int axis = 0; axis < 3; ++axis) {
        M44d flattened = at_two_metres(1.0);
        flattened[axis][axis] = 0.0;
        data.instances.push_back({.geometry = 0, .world_from_object = flattened, .materials = {}});
    }
    data.instances.push_back({.geometry = 0, .world_from_object = M44d(0.0), .materials = {}});
    const Scene scene(data, V3d(0.0));
    const auto hit = scene.intersect({.direction = V3f(0.1f, 0.2f, -1.0f).normalized()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->p_world.z, -2.0f, 1e-5f);
}

TEST(SurfaceHit, corner_normals_that_cancel_fall_back_to_the_face)
{
    Mesh mesh = square();
    mesh.normal_domain = NormalDomain::PerVertex;
    mesh.normals.assign(4, V3f(0.0f));
    const SceneData data = one(mesh, at_two_metres(1.0));
    const Scene scene(data, V3d(0.0));
    EXPECT_EQ(scene.intersect({})->point.ns, V3f(0, 0, 1));
}

// Two walls, the gap a hundred-thousandth of their distance, on a tilt and away from the origin: a
// ray that leaves the one does not meet it again, and does meet the other.
TEST(SurfaceHit, rays_leave_a_wall_and_do_not_leap_the_next_at_any_scale)
{
    for (const double size : {1e-3, 1.0, 1e4}) {
        for (const double away : {0.0, 1.0, 30.0}) {
            for (const bool is_instanced : {false, true}) {
                M44d tilted;
                tilted.rotate(V3d(0.5, 0.3, 0.2));
                M44d scaled;
                scaled.setScale(V3d(size));
                M44d to_gap;
                to_gap.setTranslation(V3d(0.0, 0.0, 2e-5 * (1.0 + away)));
                M44d at;
                at.setTranslation(V3d(away, -0.5 * away, -2.0 - away) * size);
                SceneData data = one(square(), scaled * tilted * at);
                data.instances.push_back(data.instances[0]);
                data.instances[1].world_from_object = to_gap * scaled * tilted * at;
                if (!is_instanced) {
                    data.geometries.push_back(square());
                    data.instances[1].geometry = 1;
                }
                const Scene scene(data, V3d(0.0));
                for (int i = 0; i < 500; ++i) {
                    const float s = 0.0037f * float(i) - 0.9f;
                    const float t = std::sin(7.0f * float(i)) * 0.9f;
                    V3d on_wall;
                    (scaled * tilted * at).multVecMatrix(V3d(s, t, 0.0), on_wall);
                    V3d normal;
                    tilted.multDirMatrix(V3d(0.0, 0.0, 1.0), normal);
                    const V3d from = on_wall - normal * size;
                    const auto hit =
                        scene.intersect({.origin = V3f(from), .direction = V3f(normal)});
                    ASSERT_TRUE(hit);
                    V3d aslant;
                    tilted.multDirMatrix(V3d(0.3 * s, 0.3 * t, -1.0).normalized(), aslant);
                    EXPECT_FALSE(scene.intersect(
                        {.origin = hit->origin_towards(V3f(aslant)), .direction = V3f(aslant)}))
                        << size << ' ' << away << ' ' << is_instanced << ' ' << i;
                    const auto next = scene.intersect(
                        {.origin = hit->origin_towards(V3f(normal)), .direction = V3f(normal)});
                    ASSERT_TRUE(next) << size << ' ' << away << ' ' << is_instanced << ' ' << i;
                    EXPECT_NE(next->placement, hit->placement);
                }
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
