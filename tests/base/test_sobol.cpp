// The samples are nets, they are pure functions of their key, and keys and groups are independent.

#include "base/sobol.h"
#include "chi_squared.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace eye_render {
namespace {

TEST(Sobol, table_holds_the_published_sequence)
{
    // Points 1 to 7 of Joe & Kuo's first three dimensions, in the order of their binary index.
    constexpr float expected[7][3] = {{0.5f, 0.5f, 0.5f},       {0.25f, 0.75f, 0.75f},
                                      {0.75f, 0.25f, 0.25f},    {0.125f, 0.625f, 0.375f},
                                      {0.625f, 0.125f, 0.875f}, {0.375f, 0.375f, 0.625f},
                                      {0.875f, 0.875f, 0.125f}};
    for (std::uint32_t i = 1; i <= 7; ++i) {
        const std::uint32_t top_digit = detail::reverse_bits(i) >> 28;
        for (std::size_t d = 0; d < 3; ++d) {
            const std::uint32_t word = detail::reverse_bits(detail::sobol_table[7][top_digit][d]);
            EXPECT_EQ(std::ldexp(float(word), -32), expected[i - 1][d])
                << "point " << i << ", dimension " << d;
        }
    }
}

// How many of the 2^(a + b) boxes of 2^-a by 2^-b hold exactly one of the samples of one block.
int boxes_with_one_sample(std::uint64_t key, unsigned group, unsigned block, int a, int b)
{
    const unsigned count = 1u << (a + b);
    std::vector<int> hits(count);
    for (unsigned i = 0; i < count; ++i) {
        const auto u = sobol_4d(key, block * count + i, group);
        const auto x = static_cast<unsigned>(std::ldexp(u[0], a));
        const auto y = static_cast<unsigned>(std::ldexp(u[1], b));
        ++hits[(x << b) + y];
    }
    return static_cast<int>(std::count(hits.begin(), hits.end(), 1));
}

TEST(Sobol, every_elementary_interval_of_dimensions_0_and_1_holds_one_sample)
{
    for (const std::uint64_t key : {sobol_key(0, 0), sobol_key(7, 123456)}) {
        for (const unsigned group : {0u, 5u}) {
            for (const unsigned block : {0u, 3u}) {
                for (int a = 0; a <= 10; ++a) {
                    for (int b = 0; a + b <= 10; ++b) {
                        EXPECT_EQ(boxes_with_one_sample(key, group, block, a, b), 1 << (a + b))
                            << "boxes of 2^-" << a << " by 2^-" << b << ", group " << group
                            << ", block " << block;
                    }
                }
            }
        }
    }
}

TEST(Sobol, every_dimension_is_stratified)
{
    const std::uint64_t key = sobol_key(1, 42);
    for (const unsigned count : {1u, 16u, 64u, 1024u, 65536u}) {
        for (std::size_t dimension = 0; dimension < 4; ++dimension) {
            std::set<unsigned> slices;
            for (unsigned i = 0; i < count; ++i) {
                slices.insert(unsigned(sobol_4d(key, i, 2)[dimension] * float(count)));
            }
            EXPECT_EQ(slices.size(), count) << "dimension " << dimension;
        }
    }
}

TEST(Sobol, dimensions_2_and_3_are_a_net_of_small_t)
{
    // Joe & Kuo's dimensions 2 and 3 are not a (0, 2)-sequence; at 2^8 samples no box of
    // 2^-6 area or larger may be off its count.
    constexpr int k = 8;
    constexpr int t = 2;
    const std::uint64_t key = sobol_key(0, 9);
    for (int a = 0; a <= k - t; ++a) {
        const int b = k - t - a;
        std::vector<int> hits(1u << (k - t));
        for (unsigned i = 0; i < (1u << k); ++i) {
            const auto u = sobol_4d(key, i, 0);
            const auto x = static_cast<unsigned>(std::ldexp(u[2], a));
            const auto y = static_cast<unsigned>(std::ldexp(u[3], b));
            ++hits[(x << b) + y];
        }
        EXPECT_EQ(std::count(hits.begin(), hits.end(), 1 << t), 1 << (k - t)) << "a = " << a;
    }
}

TEST(Sobol, numbers_are_at_least_0_and_below_1)
{
    float smallest = 1.0f;
    float largest = 0.0f;
    for (unsigned pixel = 0; pixel < 1024; ++pixel) {
        for (unsigned i = 0; i < 1024; ++i) {
            for (const float u : sobol_4d(sobol_key(3, pixel), i, 1)) {
                smallest = std::min(smallest, u);
                largest = std::max(largest, u);
            }
        }
    }
    EXPECT_GE(smallest, 0.0f);
    EXPECT_LT(largest, 1.0f);
    // 4 million numbers come this close to the ends.
    EXPECT_LT(smallest, 1e-5f);
    EXPECT_GT(largest, 1.0f - 1e-5f);
}

// Pearson's correlation of two sequences.
double correlation(const std::vector<double>& a, const std::vector<double>& b)
{
    const double n = double(a.size());
    double sa = 0.0, sb = 0.0, saa = 0.0, sbb = 0.0, sab = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        sa += a[i];
        sb += b[i];
        saa += a[i] * a[i];
        sbb += b[i] * b[i];
        sab += a[i] * b[i];
    }
    return (n * sab - sa * sb) / std::sqrt((n * saa - sa * sa) * (n * sbb - sb * sb));
}

TEST(Sobol, neighbouring_pixels_seeds_samples_and_groups_are_uncorrelated)
{
    constexpr unsigned pixels = 100000;
    // Five standard errors of the correlation of independent numbers.
    const double bound = 5.0 / std::sqrt(double(pixels));
    for (std::size_t d = 0; d < 4; ++d) {
        std::vector<double> here, right, other_seed, next_sample, next_group, next_dimension;
        for (unsigned pixel = 0; pixel < pixels; ++pixel) {
            const std::uint64_t key = sobol_key(0, pixel);
            here.push_back(sobol_4d(key, 0, 0)[d]);
            right.push_back(sobol_4d(sobol_key(0, pixel + 1), 0, 0)[d]);
            other_seed.push_back(sobol_4d(sobol_key(1, pixel), 0, 0)[d]);
            // Samples 0 and 1 fall into opposite halves by design; 0 and 1 of two blocks do not.
            next_sample.push_back(sobol_4d(key, 1024 + pixel % 512, 0)[d]);
            next_group.push_back(sobol_4d(key, 0, 1)[d]);
            next_dimension.push_back(sobol_4d(key, 0, 0)[(d + 1) % 4]);
        }
        EXPECT_LT(std::abs(correlation(here, right)), bound) << "dimension " << d;
        EXPECT_LT(std::abs(correlation(here, other_seed)), bound) << "dimension " << d;
        EXPECT_LT(std::abs(correlation(here, next_sample)), bound) << "dimension " << d;
        EXPECT_LT(std::abs(correlation(here, next_group)), bound) << "dimension " << d;
        EXPECT_LT(std::abs(correlation(here, next_dimension)), bound) << "dimension " << d;
    }
}

TEST(Sobol, another_seed_is_not_the_same_picture_shifted)
{
    std::set<std::uint64_t> keys;
    for (std::uint64_t seed = 0; seed < 32; ++seed) {
        for (std::uint64_t pixel = 0; pixel < 512; ++pixel) {
            keys.insert(sobol_key(seed, pixel));
        }
    }
    EXPECT_EQ(keys.size(), 32u * 512u);
}

TEST(Sobol, one_sample_is_uniform_over_the_pixels)
{
    constexpr unsigned pixels = 1u << 20;
    constexpr int cells = 32;
    for (std::size_t d = 0; d < 4; d += 2) {
        std::vector<double> observed(cells * cells);
        const std::vector<double> expected(cells * cells, double(pixels) / (cells * cells));
        for (unsigned pixel = 0; pixel < pixels; ++pixel) {
            const auto u = sobol_4d(sobol_key(5, pixel), 3, 1);
            observed[std::size_t(int(u[d] * cells) * cells + int(u[d + 1] * cells))] += 1.0;
        }
        const auto [statistic, critical] = test::chi_squared_test(observed, expected, 0.005);
        EXPECT_LT(statistic, critical) << "dimensions " << d << " and " << d + 1;
    }
}

TEST(Sobol, integrates_a_smooth_function_far_better_than_chance)
{
    // Random sampling of x*y with n samples has an RMS error of sqrt(7/144 / n).
    constexpr unsigned count = 256;
    constexpr unsigned trials = 200;
    double squared_error = 0.0;
    for (unsigned trial = 0; trial < trials; ++trial) {
        double sum = 0.0;
        for (unsigned i = 0; i < count; ++i) {
            const auto u = sobol_4d(sobol_key(0, trial), i, 0);
            sum += double(u[0]) * double(u[1]);
        }
        squared_error += std::pow(sum / count - 0.25, 2);
    }
    EXPECT_LT(std::sqrt(squared_error / trials), 0.02 * std::sqrt(7.0 / 144.0 / count));
}

}  // namespace
}  // namespace eye_render
