// Hash, Perlin noise and its fractals by what defines them.

#include "shading/procedural/hash.h"
#include "shading/procedural/noise.h"
#include "shading/procedural/perlin.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <string_view>

namespace eye_render {
namespace {

template <int D>
Point<D> random_place(std::mt19937& random, float reach)
{
    std::uniform_real_distribution<float> uniform(-reach, reach);
    return Point<D>::of_each([&](int) { return uniform(random); });
}

// Lookup3 of a text, as its author's hashlittle computes it with seed 0.
std::uint32_t lookup3_of(std::string_view text)
{
    const auto word = [&text](std::size_t first) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4 && first + i < text.size(); ++i) {
            value |= std::uint32_t(static_cast<unsigned char>(text[first + i])) << (8 * i);
        }
        return value;
    };
    const auto initial = 0xdeadbeefu + static_cast<std::uint32_t>(text.size());
    lookup3::State state{initial, initial, initial};
    std::size_t first = 0;
    for (; text.size() - first > 12; first += 12) {
        state.a += word(first);
        state.b += word(first + 4);
        state.c += word(first + 8);
        state.mix();
    }
    state.a += word(first);
    state.b += word(first + 4);
    state.c += word(first + 8);
    state.finish();
    return state.c;
}

TEST(Lookup3, hashes_the_authors_own_example)
{
    // driver5 of burtleburtle.net/bob/c/lookup3.c.
    EXPECT_EQ(lookup3_of("Four score and seven years ago"), 0x17770551u);
}

TEST(Lookup3, unit_hashes_are_uniform)
{
    constexpr int count = 100'000;
    double sum = 0.0;
    double squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const float x = unit_hash(static_cast<float>(i), 0.5f);
        ASSERT_TRUE(x >= 0.0f && x <= 1.0f);
        sum += x;
        squares += double(x) * x;
    }
    // Five standard errors of the mean of x and of x^2.
    EXPECT_NEAR(sum / count, 0.5, 5.0 * std::sqrt(1.0 / 12.0 / count));
    EXPECT_NEAR(squares / count, 1.0 / 3.0, 5.0 * std::sqrt(4.0 / 45.0 / count));
}

template <typename Dimension>
class PerlinNoise : public ::testing::Test {
};
using Dimensions = ::testing::Types<Point<1>, Point<2>, Point<3>, Point<4>>;
TYPED_TEST_SUITE(PerlinNoise, Dimensions);

TYPED_TEST(PerlinNoise, is_zero_at_whole_numbers)
{
    std::mt19937 random(1);
    for (int i = 0; i < 1000; ++i) {
        TypeParam p;
        for (float& x : p.coordinates) {
            x = static_cast<float>(std::uniform_int_distribution(-99'999, 99'999)(random));
        }
        EXPECT_EQ(perlin_noise(p), 0.0f);
    }
}

TYPED_TEST(PerlinNoise, stays_in_its_range_and_comes_near_its_ends)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(-1000.0f, 1000.0f);
    float least = 0.0f;
    float most = 0.0f;
    for (int i = 0; i < 100'000; ++i) {
        TypeParam p;
        for (float& x : p.coordinates) {
            x = uniform(random);
        }
        const float value = perlin_noise(p);
        least = std::min(least, value);
        most = std::max(most, value);
    }
    EXPECT_GE(least, -1.0f);
    EXPECT_LE(most, 1.0f);
    EXPECT_LT(least, -0.6f);
    EXPECT_GT(most, 0.6f);
}

TYPED_TEST(PerlinNoise, passes_from_cell_to_cell_without_a_step_or_a_bend)
{
    // Its second derivative is at most about 60 in any dimension, so over a step h slopes differ
    // by 60 h, and rounding adds an error of the noise over h.
    constexpr float step = 1.0f / 256.0f;
    constexpr float bend = 60.0f * step + 1e-6f / step;
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(-30.0f, 30.0f);
    for (int i = 0; i < 2000; ++i) {
        TypeParam p;
        for (float& x : p.coordinates) {
            x = uniform(random);
        }
        const auto axis = random() % p.coordinates.size();
        const float border = std::round(p.coordinates[axis]);
        const auto value_at = [&](float distance) {
            TypeParam place = p;
            place.coordinates[axis] = border + distance;
            return perlin_noise(place);
        };
        const float slope_before = (value_at(0.0f) - value_at(-step)) / step;
        const float slope_after = (value_at(step) - value_at(0.0f)) / step;
        EXPECT_NEAR(slope_before, slope_after, bend) << "axis " << axis << " at " << border;
    }
}

TYPED_TEST(PerlinNoise, repeats_far_away)
{
    std::mt19937 random(4);
    for (int i = 0; i < 1000; ++i) {
        TypeParam near;
        TypeParam far;
        for (std::size_t axis = 0; axis < near.coordinates.size(); ++axis) {
            // Quarters, which floats below 2^22 hold exactly.
            const int quarters = std::uniform_int_distribution(0, 4 * 9999)(random);
            near.coordinates[axis] = static_cast<float>(quarters) / 4.0f;
            far.coordinates[axis] = near.coordinates[axis] + 700'000.0f;
        }
        EXPECT_EQ(perlin_noise(near), perlin_noise(far));
    }
}

TYPED_TEST(PerlinNoise, is_zero_where_a_coordinate_is_not_finite)
{
    constexpr float infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {infinity, -infinity, std::nanf("")}) {
        TypeParam p;
        p.coordinates.fill(bad);
        EXPECT_EQ(perlin_noise(p), 0.0f);
    }
}

TEST(Fractal, without_detail_is_one_octave)
{
    std::mt19937 random(5);
    for (int i = 0; i < 100; ++i) {
        const auto p = random_place<3>(random, 9.0f);
        const float octave = perlin_noise(p);
        EXPECT_FLOAT_EQ(fractal_noise(p, {.is_normalized = false, .detail = 0.0f}), octave);
        EXPECT_FLOAT_EQ(fractal_noise(p, {.detail = 0.0f}), 0.5f + 0.5f * octave);
    }
}

TEST(Fractal, detail_between_whole_numbers_leads_from_one_to_the_next)
{
    const Point<3> p{{0.3f, -1.7f, 2.2f}};
    for (const FractalType type : {FractalType::Fbm, FractalType::Multifractal,
                                   FractalType::HybridMultifractal, FractalType::HeteroTerrain}) {
        const auto at = [&](float detail) {
            return fractal_noise(p, {.type = type, .detail = detail, .offset = 0.7f});
        };
        for (const float detail : {1.0f, 2.0f, 5.0f}) {
            EXPECT_NEAR(at(detail - 1e-4f), at(detail), 1e-3f);
            EXPECT_NEAR(at(detail + 1e-4f), at(detail), 1e-3f);
        }
    }
}

TEST(Fractal, has_at_most_fifteen_more_octaves)
{
    const Point<2> p{{0.37f, 11.1f}};
    EXPECT_EQ(fractal_noise(p, {.detail = 1e30f}), fractal_noise(p, {.detail = 15.0f}));
}

TEST(Fractal, normalized_brownian_motion_stays_between_0_and_1)
{
    std::mt19937 random(6);
    for (int i = 0; i < 20'000; ++i) {
        const float roughness = std::uniform_real_distribution(0.0f, 2.0f)(random);
        const float value =
            fractal_noise(random_place<3>(random, 50.0f), {.roughness = roughness});
        ASSERT_TRUE(value >= 0.0f && value <= 1.0f) << value;
    }
}

TEST(Noise, value_alone_is_the_colours_red)
{
    std::mt19937 random(7);
    const Noise noise{.fractal = {.detail = 3.5f}, .distortion = 0.8f};
    for (int i = 0; i < 100; ++i) {
        const auto p = random_place<4>(random, 9.0f);
        EXPECT_EQ(noise_value(p, noise), noise_color(p, noise).x);
    }
}

}  // namespace
}  // namespace eye_render
