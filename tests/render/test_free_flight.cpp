// Distances: densities integrate to one, and samples are spread as they say.

#include "render/free_flight.h"

#include "../base/chi_squared.h"
#include "base/sobol.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
const Color3f extinction(0.2f, 1.0f, 6.0f);
const Color3f importance(1.0f, 0.5f, 0.3f);

// The cells of [0, end), and those above as one more.
template <typename Sample, typename Pdf>
void expect_spread(float end, double within, const Sample& sample, const Pdf& pdf)
{
    constexpr int cells = 100;
    constexpr int finer = 200;
    constexpr int count = 1 << 20;
    std::vector<double> expected(cells + 1, 0.0);
    const double width = double(end) / (cells * finer);
    double integral = 0.0;
    for (int i = 0; i < cells * finer; ++i) {
        const double share = double(pdf(static_cast<float>((i + 0.5) * width))) * width;
        integral += share;
        expected[static_cast<std::size_t>(i / finer)] += share * count;
    }
    EXPECT_NEAR(integral, within, 1e-3);
    expected.back() = std::max(0.0, 1.0 - integral) * count;
    std::vector<double> observed(cells + 1, 0.0);
    const std::uint64_t key = sobol_key(5, 0);
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto u = sobol_4d(key, i, 0);
        const double place = double(sample(u[0], u[1])) / double(end) * cells;
        observed[static_cast<std::size_t>(std::min(place, double(cells)))] += 1.0;
    }
    const auto chi = test::chi_squared_test(observed, expected, 0.01);
    EXPECT_LT(chi.statistic, chi.critical);
}

TEST(FreeFlight, collides_as_its_density_says_or_survives)
{
    const FreeFlight flight(extinction, importance, 2.0f);
    expect_spread(
        2.0f, 1.0 - double(flight.survival(2.0f)),
        [&](float u, float v) { return flight.sample(u, v); },
        [&](float t) { return flight.pdf(t); });
}

TEST(FreeFlight, collides_for_certain_where_a_collision_is_given)
{
    for (const float length : {1e-3f, 0.5f, 20.0f}) {
        const FreeFlight flight(extinction, importance, length);
        expect_spread(
            length, 1.0, [&](float u, float v) { return flight.sample_within(u, v); },
            [&](float t) { return flight.pdf_within(t); });
    }
}

TEST(FreeFlight, never_collides_in_a_channel_without_a_medium)
{
    const FreeFlight flight(Color3f(0.0f, 1.0f, 1.0f), Color3f(1.0f), infinity);
    EXPECT_EQ(flight.sample(0.1f, 0.0f), infinity);
    EXPECT_LT(flight.sample(0.9f, 0.99f), 10.0f);
    EXPECT_FLOAT_EQ(flight.survival(infinity), 1.0f / 3.0f);
}

// What its one-sample combination is for: no channel's weight exceeds one over its share.
TEST(FreeFlight, weights_stay_bounded_whatever_the_colors)
{
    const FreeFlight flight({0.01f, 1.0f, 100.0f}, Color3f(1.0f), 3.0f);
    for (const float t : {1e-3f, 0.1f, 2.9f}) {
        for (const float e : {0.01f, 1.0f, 100.0f}) {
            EXPECT_LE(e * std::exp(-e * t) / flight.pdf(t), 3.001f);
            EXPECT_LE(std::exp(-e * 3.0f) / flight.survival(3.0f), 3.001f);
        }
    }
}

TEST(EquiangularDistance, is_spread_as_its_density_says)
{
    const V3f origin(1.0f, 0.0f, 0.0f);
    const V3f along(0.0f, 0.0f, -1.0f);
    // Beside the ray, behind its start, beyond its end.
    for (const V3f& pivot :
         {V3f(1.5f, 0.0f, -1.0f), V3f(1.0f, 1.0f, 2.0f), V3f(1.0f, 0.3f, -9.0f)}) {
        const EquiangularDistance distance(origin, along, 3.0f, pivot);
        expect_spread(
            3.0f, 1.0, [&](float, float v) { return distance.sample(v); },
            [&](float t) { return distance.pdf(t); });
    }
}

TEST(EquiangularDistance, reaches_infinitely_far)
{
    const EquiangularDistance distance(V3f(0.0f), V3f(1.0f, 0.0f, 0.0f), infinity,
                                       V3f(2.0f, 0.5f, 0.0f));
    EXPECT_GT(distance.sample(0.9999f), 1000.0f);
    double integral = 0.0;
    for (int i = 0; i < 200000; ++i) {
        integral += double(distance.pdf((static_cast<float>(i) + 0.5f) * 1e-2f)) * 1e-2;
    }
    EXPECT_NEAR(integral, 1.0, 1e-3);
}

TEST(EquiangularDistance, is_finite_where_the_pivot_is_on_the_ray)
{
    for (const float length : {4.0f, infinity}) {
        const EquiangularDistance distance(V3f(0.0f), V3f(1.0f, 0.0f, 0.0f), length,
                                           V3f(2.0f, 0.0f, 0.0f));
        for (const float u : {0.0f, 0.3f, 0.5f, 0.999f}) {
            const float t = distance.sample(u);
            EXPECT_GE(t, 0.0f);
            EXPECT_TRUE(std::isfinite(distance.pdf(t)) && distance.pdf(t) > 0.0f) << t;
        }
    }
}

}  // namespace
}  // namespace eye_render
