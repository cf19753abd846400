#include "scene/transform.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

M44d made_of(const V3d& x, const V3d& y, const V3d& z, const V3d& at)
{
    return {x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, at.x, at.y, at.z, 1};
}

TEST(Transform, far_from_the_origin_keeps_what_is_near_the_eye)
{
    const V3d eye(1e7, -1e7, 5e6);
    const M44d object = made_of({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, eye + V3d(0.001, 0.002, -0.003));
    const M44f relative = to_float(relative_to_eye(object, eye));
    // A double holds 1e7 to 2e-9.
    EXPECT_NEAR(relative[3][0], 0.001f, 4e-9f);
    EXPECT_NEAR(relative[3][1], 0.002f, 4e-9f);
    EXPECT_NEAR(relative[3][2], -0.003f, 4e-9f);
}

TEST(Transform, normals_stay_perpendicular_under_uneven_scale)
{
    const M44d m = made_of({2, 1, 0}, {0, 3, 1}, {0, 0.5, 0.1}, {5, 6, 7});
    const M33f normals = normal_matrix(m);
    const V3f a(1, 2, 3);
    const V3f b(-2, 0.5f, 1);
    V3f a_world;
    V3f b_world;
    to_float(m).multDirMatrix(a, a_world);
    to_float(m).multDirMatrix(b, b_world);
    const V3f n = (a.cross(b) * normals).normalized();
    EXPECT_NEAR(n.dot(a_world.normalized()), 0.0f, 1e-5f);
    EXPECT_NEAR(n.dot(b_world.normalized()), 0.0f, 1e-5f);
}

TEST(Transform, a_mirror_keeps_normals_on_their_side)
{
    const M44d mirror = made_of({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, V3d(0.0));
    EXPECT_TRUE(is_mirror(mirror));
    EXPECT_EQ(V3f(1, 0, 0) * normal_matrix(mirror), V3f(-1, 0, 0));
    EXPECT_EQ(V3f(0, 1, 0) * normal_matrix(mirror), V3f(0, 1, 0));
}

TEST(Transform, a_flattened_object_has_the_normal_of_its_plane)
{
    const M44d flat = made_of({1, 0, 0}, {0, 1, 0}, {0, 0, 0}, V3d(0.0));
    EXPECT_EQ(V3f(0, 0, 1) * normal_matrix(flat), V3f(0, 0, 1));
}

TEST(Transform, micrometre_objects_keep_their_normals)
{
    const M44d tiny = made_of({1e-25, 0, 0}, {0, 1e-25, 0}, {0, 0, 1e-25}, V3d(0.0));
    EXPECT_EQ(V3f(0, 0, 1) * normal_matrix(tiny), V3f(0, 0, 1));
}

}  // namespace
}  // namespace eye_render
