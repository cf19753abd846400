// The acceleration structure against testing every triangle.

#include "scene/accelerator.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

struct Soup {
    std::vector<V3f> positions;
    std::vector<TriangleIndices> triangles;
};

Shape shape_of(const Soup& soup) { return TriangleShape{soup.triangles, {{soup.positions}}}; }

Soup random_soup(std::mt19937& random, int count)
{
    std::uniform_real_distribution<float> place(-1.0f, 1.0f);
    Soup soup;
    for (int i = 0; i < count; ++i) {
        const V3f at(place(random), place(random), place(random));
        const auto first = static_cast<std::uint32_t>(soup.positions.size());
        for (int corner = 0; corner < 3; ++corner) {
            soup.positions.push_back(at + V3f(place(random), place(random), place(random)) * 0.2f);
        }
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

// Nearest distance by Cramer's rule in double over all triangles; infinity without a hit.
double brute_force(const Soup& soup, const V3d& origin, const V3d& direction)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (const TriangleIndices& t : soup.triangles) {
        const V3d p0(soup.positions[t[0]]);
        const V3d e1 = V3d(soup.positions[t[1]]) - p0;
        const V3d e2 = V3d(soup.positions[t[2]]) - p0;
        const double det = e1.dot(direction.cross(e2));
        const V3d s = origin - p0;
        const double u = s.dot(direction.cross(e2)) / det;
        const double v = direction.dot(s.cross(e1)) / det;
        const double distance = e2.dot(s.cross(e1)) / det;
        if (u >= 0 && v >= 0 && u + v <= 1 && distance > 0) {
            nearest = std::min(nearest, distance);
        }
    }
    return nearest;
}

TEST(Accelerator, finds_what_testing_every_triangle_finds)
{
    std::mt19937 random(1);
    const Soup soup = random_soup(random, 300);
    Accelerator accelerator;
    EXPECT_EQ(accelerator.add_flat(shape_of(soup)), 0u);
    accelerator.build();
    std::normal_distribution<float> normal;
    int hits = 0;
    for (int i = 0; i < 2000; ++i) {
        const Ray ray{.origin = V3f(normal(random), normal(random), normal(random)),
                      .direction =
                          V3f(normal(random), normal(random), normal(random)).normalized()};
        const double expected = brute_force(soup, V3d(ray.origin), V3d(ray.direction));
        const auto found = accelerator.intersect(ray);
        ASSERT_EQ(found.has_value(), std::isfinite(expected)) << i;
        EXPECT_EQ(accelerator.occluded(ray), found.has_value());
        if (found) {
            ++hits;
            EXPECT_NEAR(found->t, expected, 1e-4);
            // The barycentric weights belong to the corners in their order.
            const TriangleIndices& t = soup.triangles[found->primitive];
            const V3f p = soup.positions[t[0]] * (1 - found->u - found->v) +
                          soup.positions[t[1]] * found->u + soup.positions[t[2]] * found->v;
            EXPECT_LT((p - (ray.origin + ray.direction * found->t)).length(), 1e-4f);
        }
    }
    EXPECT_GT(hits, 200);
}

TEST(Accelerator, placed_prototype_is_hit_where_its_matrix_puts_it)
{
    const std::vector<V3f> positions{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
    const std::vector<TriangleIndices> triangles{{0, 1, 2}};
    Accelerator accelerator;
    const auto prototype = accelerator.add_prototype(TriangleShape{triangles, {{positions}}});
    M44d near;
    near.setTranslation(V3d(0, 0, -2));
    M44d far;
    far.setTranslation(V3d(5, 0, -7));
    EXPECT_EQ(accelerator.place(prototype, {{near}}), 0u);
    EXPECT_EQ(accelerator.place(prototype, {{far}}), 1u);
    accelerator.build();
    const auto straight = accelerator.intersect({});
    ASSERT_TRUE(straight);
    EXPECT_EQ(straight->placement, 0u);
    EXPECT_NEAR(straight->t, 2.0f, 1e-5f);
    const auto right = accelerator.intersect({.origin = V3f(5, 0, 0)});
    ASSERT_TRUE(right);
    EXPECT_EQ(right->placement, 1u);
    EXPECT_NEAR(right->t, 7.0f, 1e-5f);
    EXPECT_FALSE(accelerator.intersect({.origin = V3f(5, 0, 0), .t_max = 6.0f}));
}

TEST(Accelerator, a_ray_meets_what_shares_a_bit_with_its_mask)
{
    const std::vector<V3f> positions{{-1, -1, -1}, {1, -1, -1}, {0, 1, -1}};
    const std::vector<TriangleIndices> triangles{{0, 1, 2}};
    const TriangleShape shape{triangles, {{positions}}};
    Accelerator accelerator;
    accelerator.add_flat(shape, 0b01);
    // In the same place, so that nothing but the mask tells them apart.
    const std::vector<M44d> place{M44d()};
    accelerator.place(accelerator.add_prototype(shape), place, 0b10);
    accelerator.build();
    for (const RayMask mask : {0b01u, 0b10u}) {
        const auto found = accelerator.intersect({}, mask);
        ASSERT_TRUE(found) << mask;
        EXPECT_EQ(found->placement, mask == 0b01u ? 0u : 1u);
        EXPECT_TRUE(accelerator.occluded({}, mask)) << mask;
    }
    EXPECT_FALSE(accelerator.intersect({}, 0b100));
    EXPECT_FALSE(accelerator.occluded({}, 0b100));
}

TEST(Accelerator, rays_that_are_not_finite_bring_no_light)
{
    std::mt19937 random(1);
    const Soup soup = random_soup(random, 10);
    Accelerator accelerator;
    accelerator.add_flat(shape_of(soup));
    accelerator.build();
    const float nan = std::nanf("");
    for (const Ray& ray : {Ray{.origin = V3f(nan, 0, 0)}, Ray{.direction = V3f(0, nan, 0)},
                           Ray{.origin = V3f(0, 0, INFINITY)}, Ray{.t_max = nan}}) {
        EXPECT_FALSE(accelerator.intersect(ray));
        EXPECT_TRUE(accelerator.occluded(ray));
    }
}

TEST(Accelerator, empty_scene_is_hit_by_nothing)
{
    Accelerator accelerator;
    accelerator.build();
    EXPECT_FALSE(accelerator.intersect({}));
    EXPECT_FALSE(accelerator.occluded({}));
}

}  // namespace
}  // namespace eye_render
