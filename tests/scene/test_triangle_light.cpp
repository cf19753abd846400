// A triangle as it is sampled from a point, near and far.

#include "scene/triangle_light.h"

#include "../base/chi_squared.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

constexpr std::array<V3f, 3> corners{V3f(-1.0f, -0.5f, 0.0f), V3f(1.2f, -0.4f, 0.3f),
                                     V3f(0.1f, 1.0f, -0.2f)};
constexpr int strata = 8;  // a side, of the weights of the second and third corner

// Near, at an edge's height, far, and where hardly anything of the plane is seen.
const std::vector<V3f> places{{0.1f, 0.0f, 0.5f},
                              {0.3f, 0.2f, -0.1f},
                              {2.0f, 3.0f, 8.0f},
                              {4.0f, 0.2f, 0.8f},
                              {2.5f, 0.1f, 0.55f}};

V3f at(const V2f& weights)
{
    return corners[0] * (1.0f - weights.x - weights.y) + corners[1] * weights.x +
           corners[2] * weights.y;
}

std::size_t stratum(const V2f& weights)
{
    const auto cell = [](float w) { return std::clamp(int(w * strata), 0, strata - 1); };
    return std::size_t(cell(weights.x) * strata + cell(weights.y));
}

TEST(TriangleLight, samples_follow_their_density)
{
    constexpr int samples = 200000;
    constexpr int fine = 50 * strata;
    const V3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
    for (const V3f& p : places) {
        const TriangleLight light(corners, p);
        std::vector<double> observed(strata * strata);
        std::mt19937 rng(7);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        for (int i = 0; i < samples; ++i) {
            ++observed[stratum(light.sample({uniform(rng), uniform(rng)}))];
        }
        // The density per unit solid angle, over a grid of area.
        std::vector<double> expected(strata * strata);
        double sum = 0.0;
        for (int i = 0; i < fine; ++i) {
            for (int j = 0; j < fine - i; ++j) {
                // Two small triangles a square of the grid, but one at the long edge.
                for (const float third : {1.0f / 3.0f, 2.0f / 3.0f}) {
                    if (third > 0.5f && i + j + 1 == fine) {
                        continue;
                    }
                    const V2f weights((float(i) + third) / fine, (float(j) + third) / fine);
                    const V3f to_light = at(weights) - p;
                    const double distance = to_light.length();
                    const double solid_angle =
                        std::abs(double(normal.dot(to_light))) /
                        (2.0 * fine * fine * distance * distance * distance);
                    const double share = light.pdf(to_light) * solid_angle;
                    expected[stratum(weights)] += samples * share;
                    sum += share;
                }
            }
        }
        EXPECT_NEAR(sum, 1.0, 2e-3) << p;
        const auto test = test::chi_squared_test(observed, expected, 0.01 / double(places.size()));
        EXPECT_LT(test.statistic, test.critical) << p;
    }
}

TEST(TriangleLight, seen_near_it_is_equally_bright_in_all_samples)
{
    const TriangleLight light(corners, places[0]);
    const float first = light.pdf(at({0.1f, 0.1f}) - places[0]);
    EXPECT_EQ(light.pdf(at({0.8f, 0.1f}) - places[0]), first);
}

TEST(TriangleLight, nothing_is_sampled_of_one_without_area)
{
    const TriangleLight flat({V3f(0.0f), V3f(1.0f), V3f(2.0f)}, V3f(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(flat.pdf(V3f(1.0f, 1.0f, 0.0f)), 0.0f);
}

}  // namespace
}  // namespace eye_render
