// When the shutter lets paths see the scene.

#include "render/shutter.h"

#include "../base/chi_squared.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

namespace eye_render {
namespace {

const std::vector<std::vector<double>> curves{{1.0, 1.0},
                                              {0.0, 1.0},
                                              {1.0, 0.0},
                                              {0.0, 2.0, 0.0},
                                              {0.0, 0.0, 1.0, 0.0, 0.5}};

TEST(Shutter, times_follow_how_far_it_is_open)
{
    constexpr int samples = 100000;
    constexpr int cells = 40;
    for (std::size_t c = 0; c < curves.size(); ++c) {
        const Shutter shutter(curves[c]);
        std::vector<double> observed(cells);
        std::mt19937 rng(3);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        for (int i = 0; i < samples; ++i) {
            const float time = shutter.sample(uniform(rng));
            ASSERT_GE(time, 0.0f);
            ASSERT_LE(time, 1.0f);
            ++observed[std::min(std::size_t(time * cells), std::size_t(cells - 1))];
        }
        std::vector<double> expected(cells);
        double sum = 0.0;
        for (int i = 0; i < cells; ++i) {
            // Straight within each cell, as cells are parts of steps.
            const double share = shutter.pdf((i + 0.5) / cells) / cells;
            expected[std::size_t(i)] = samples * share;
            sum += share;
        }
        EXPECT_NEAR(sum, 1.0, 1e-12) << "curve " << c;
        const auto test = test::chi_squared_test(observed, expected, 0.01 / double(curves.size()));
        EXPECT_LT(test.statistic, test.critical) << "curve " << c;
    }
}

TEST(Shutter, later_numbers_are_later_times)
{
    for (const auto& curve : curves) {
        const Shutter shutter(curve);
        for (int i = 0; i < 100; ++i) {
            EXPECT_LE(shutter.sample(float(i) / 101), shutter.sample(float(i + 1) / 101));
        }
    }
}

TEST(Shutter, one_that_lets_no_light_in_is_refused)
{
    EXPECT_THROW(Shutter({1.0}), std::invalid_argument);
    EXPECT_THROW(Shutter({0.0, 0.0}), std::invalid_argument);
    EXPECT_THROW(Shutter({1.0, -0.1}), std::invalid_argument);
    EXPECT_THROW(Shutter({1.0, NAN}), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
