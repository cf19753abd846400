#include "render/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

TEST(PixelFilter, spreads_over_its_width_to_each_side_and_no_further)
{
    const PixelFilter filter(1.5);
    EXPECT_NEAR(filter.sample({0.0f, 0.0f}).x, -1.5, 1e-9);
    EXPECT_NEAR(filter.sample({0.99999994f, 0.0f}).x, 1.5, 2e-3);
    EXPECT_NEAR(filter.sample({0.5f, 0.5f}).x, 0.0, 1e-9);
}

TEST(PixelFilter, has_the_standard_deviation_of_a_blackman_harris_window)
{
    const PixelFilter filter(1.0);
    double sum = 0.0;
    constexpr int n = 4096;
    for (int i = 0; i < n; ++i) {
        const double x = filter.sample({(static_cast<float>(i) + 0.5f) / n, 0.5f}).x;
        sum += x * x / n;
    }
    // Second moment of the window by the trapezoid rule, which is exact to rounding for it.
    double weight = 0.0;
    double moment = 0.0;
    for (int i = 0; i < 20000; ++i) {
        const double x = -1.0 + 2.0 * i / 20000;
        const double w = 0.35875 + 0.48829 * std::cos(M_PI * x) +
                         0.14128 * std::cos(2 * M_PI * x) + 0.01168 * std::cos(3 * M_PI * x);
        weight += w;
        moment += w * x * x;
    }
    // The table's outermost cells, where the window is nearly 0, are wide: 0.3 % too much spread.
    EXPECT_NEAR(sum, moment / weight, 5e-3 * moment / weight);
}

TEST(PixelFilter, refuses_a_width_of_zero)
{
    EXPECT_THROW(PixelFilter(0.0), std::invalid_argument);
    EXPECT_THROW(PixelFilter(std::nan("")), std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
