// Voronoi textures by what defines them.

#include "shading/procedural/voronoi.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

constexpr int trials = 2000;
// Places have up to 100 cells to the origin, and the texture is of scale 5.
constexpr float rounding = 1e-4f;

template <int D>
Point<D> random_place(std::mt19937& random)
{
    std::uniform_real_distribution<float> uniform(-20.0f, 20.0f);
    return Point<D>::of_each([&](int) { return uniform(random); });
}

Point<3> point_of(const V3f& v) { return {{v.x, v.y, v.z}}; }

TEST(Voronoi, distance_is_that_to_the_position_it_tells)
{
    std::mt19937 random(1);
    for (const VoronoiFeature feature : {VoronoiFeature::F1, VoronoiFeature::F2}) {
        const Voronoi voronoi{.feature = feature};
        for (int i = 0; i < trials; ++i) {
            const Point<3> p = random_place<3>(random);
            const VoronoiAnswer answer = voronoi_texture(p, voronoi);
            const Point<3> way = p - point_of(answer.position);
            EXPECT_NEAR(answer.distance, 5.0f * std::sqrt(dot(way, way)), rounding);
        }
    }
}

TEST(Voronoi, distance_at_the_nearest_point_is_zero_and_the_colour_its_cells)
{
    std::mt19937 random(2);
    for (int i = 0; i < trials; ++i) {
        const VoronoiAnswer answer = voronoi_texture(random_place<3>(random), Voronoi{});
        const VoronoiAnswer there = voronoi_texture(point_of(answer.position), Voronoi{});
        EXPECT_NEAR(there.distance, 0.0f, rounding);
        EXPECT_EQ(there.color, answer.color);
    }
}

TEST(Voronoi, the_next_point_is_farther_and_the_smooth_distance_shorter)
{
    std::mt19937 random(3);
    for (const VoronoiMetric metric : {VoronoiMetric::Euclidean, VoronoiMetric::Manhattan,
                                       VoronoiMetric::Chebychev, VoronoiMetric::Minkowski}) {
        for (int i = 0; i < trials; ++i) {
            const Point<3> p = random_place<3>(random);
            const auto distance_of = [&](VoronoiFeature feature) {
                return voronoi_texture(p, {.feature = feature, .metric = metric}).distance;
            };
            const float f1 = distance_of(VoronoiFeature::F1);
            EXPECT_GE(distance_of(VoronoiFeature::F2), f1);
            EXPECT_LE(distance_of(VoronoiFeature::SmoothF1), f1 + rounding);
        }
    }
}

TEST(Voronoi, points_without_randomness_are_the_grid)
{
    std::mt19937 random(4);
    for (int i = 0; i < trials; ++i) {
        const Point<2> p = random_place<2>(random);
        const float x = p[0] - std::round(p[0]);
        const float y = p[1] - std::round(p[1]);
        const Voronoi grid{.randomness = 0.0f, .scale = 1.0f};
        EXPECT_NEAR(voronoi_texture(p, grid).distance, std::hypot(x, y), rounding);
        const Voronoi edges{
            .feature = VoronoiFeature::DistanceToEdge, .randomness = 0.0f, .scale = 1.0f};
        EXPECT_NEAR(voronoi_texture(p, edges).distance, 0.5f - std::max(std::abs(x), std::abs(y)),
                    rounding);
        const Voronoi spheres{
            .feature = VoronoiFeature::NSphereRadius, .randomness = 0.0f, .scale = 1.0f};
        EXPECT_EQ(voronoi_texture(p, spheres).radius, 0.5f);
    }
}

// The bisector of the two nearest points is an edge, or beyond a nearer one.
TEST(Voronoi, no_edge_is_nearer_than_half_of_what_the_two_nearest_points_differ_by)
{
    std::mt19937 random(5);
    for (int i = 0; i < trials; ++i) {
        const Point<3> p = random_place<3>(random);
        const auto distance_of = [&](VoronoiFeature feature) {
            return voronoi_texture(p, {.feature = feature}).distance;
        };
        const float gap = distance_of(VoronoiFeature::F2) - distance_of(VoronoiFeature::F1);
        EXPECT_GE(distance_of(VoronoiFeature::DistanceToEdge), 0.5f * gap - rounding);
    }
}

TEST(Voronoi, a_coordinate_that_is_not_finite_counts_as_0)
{
    const float distance = voronoi_texture(Point<3>{{0.0f, 1.3f, 2.6f}}, Voronoi{}).distance;
    for (const float bad : {INFINITY, -INFINITY, NAN}) {
        const Point<3> p{{bad, 1.3f, 2.6f}};
        EXPECT_EQ(voronoi_texture(p, Voronoi{}).distance, distance);
    }
}

template <int D>
void expect_continuous(const Voronoi& voronoi, float most_per_cell)
{
    constexpr float step = 1e-3f;
    std::mt19937 random(6);
    for (int i = 0; i < trials; ++i) {
        const Point<D> p = random_place<D>(random);
        Point<D> moved = p;
        moved[0] += step;
        const float change =
            voronoi_texture(moved, voronoi).distance - voronoi_texture(p, voronoi).distance;
        EXPECT_LE(std::abs(change), most_per_cell * voronoi.scale * step + rounding);
    }
}

TEST(Voronoi, distances_change_no_faster_than_places)
{
    expect_continuous<1>({.feature = VoronoiFeature::F1}, 1.0f);
    expect_continuous<2>({.feature = VoronoiFeature::F1}, 1.0f);
    expect_continuous<2>({.feature = VoronoiFeature::F1, .metric = VoronoiMetric::Manhattan},
                         1.0f);
    expect_continuous<3>({.feature = VoronoiFeature::SmoothF1}, 1.0f);
    // Two octaves: one half as high and twice as steep.
    expect_continuous<2>({.feature = VoronoiFeature::F1, .detail = 1.0f}, 2.0f);
}

TEST(Voronoi, normalized_distances_and_colours_are_between_0_and_1)
{
    std::mt19937 random(7);
    for (const VoronoiFeature feature :
         {VoronoiFeature::F1, VoronoiFeature::F2, VoronoiFeature::DistanceToEdge}) {
        for (int i = 0; i < trials; ++i) {
            const Voronoi voronoi{.feature = feature,
                                  .is_normalized = true,
                                  .detail = std::uniform_real_distribution(0.0f, 4.0f)(random)};
            const VoronoiAnswer answer = voronoi_texture(random_place<3>(random), voronoi);
            for (const float x :
                 {answer.distance, answer.color.x, answer.color.y, answer.color.z}) {
                EXPECT_TRUE(x >= 0.0f && x <= 1.0f + rounding) << x;
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
