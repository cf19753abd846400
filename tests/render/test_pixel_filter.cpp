#include "render/pixel_filter.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

TEST(PixelFilter, spreads_over_its_width_to_each_side_and_no_further)
{
    const PixelFilter filter(PixelFilterKind::BlackmanHarris, 1.5);
    EXPECT_NEAR(filter.sample({0.0f, 0.0f}).x, -1.5, 1e-9);
    EXPECT_NEAR(filter.sample({0.99999994f, 0.0f}).x, 1.5, 2e-3);
    EXPECT_NEAR(filter.sample({0.5f, 0.5f}).x, 0.0, 1e-9);
}

TEST(PixelFilter, has_the_standard_deviation_of_a_blackman_harris_window)
{
    const PixelFilter filter(PixelFilterKind::BlackmanHarris, 1.0);
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

// Of Cycles' formulas, unnormalised, at a distance along an axis.
double formula(PixelFilterKind kind, double x, double width)
{
    switch (kind) {
    case PixelFilterKind::Box: return std::abs(x) <= 0.5 ? 1.0 : 0.0;
    case PixelFilterKind::Gaussian:
        return std::abs(x) <= 1.5 * width ? std::exp(-8.0 * x * x / (width * width)) : 0.0;
    case PixelFilterKind::BlackmanHarris: break;
    }
    if (std::abs(x) > width) {
        return 0.0;
    }
    const double turn = M_PI * x / width;
    return 0.35875 + 0.48829 * std::cos(turn) + 0.14128 * std::cos(2 * turn) +
           0.01168 * std::cos(3 * turn);
}

TEST(PixelFilter, sends_samples_where_its_formula_is_large)
{
    for (const PixelFilterKind kind : pixel_filter_kinds) {
        for (const double width : {1.0, 3.0}) {
            const PixelFilter filter(kind, width);
            // The share of samples below x is the formula's integral up to there.
            constexpr int steps = 60000;
            const double reach = 1.6 * width;
            double whole = 0.0;
            for (int i = 0; i < steps; ++i) {
                whole += formula(kind, -reach + 2.0 * reach * (i + 0.5) / steps, width);
            }
            double below = 0.0;
            int step = 0;
            for (const float u : {0.01f, 0.2f, 0.5f, 0.7f, 0.9f, 0.99f}) {
                const double x = filter.sample({u, 0.5f}).x;
                for (; step < steps && -reach + 2.0 * reach * (step + 0.5) / steps < x; ++step) {
                    below += formula(kind, -reach + 2.0 * reach * (step + 0.5) / steps, width);
                }
                // Within a step of the sums and a cell of the table, drawn as a line.
                EXPECT_NEAR(below / whole, static_cast<double>(u), 2e-4)
                    << to_string(kind) << ' ' << width << " at " << x;
            }
        }
    }
}

TEST(PixelFilter, of_a_box_is_a_pixel_whatever_its_width)
{
    const PixelFilter filter(PixelFilterKind::Box, 4.0);
    EXPECT_NEAR(filter.sample({0.0f, 0.5f}).x, -0.5, 1e-9);
    EXPECT_NEAR(filter.sample({0.25f, 0.5f}).x, -0.25, 1e-9);
}

TEST(PixelFilter, refuses_a_width_of_zero)
{
    EXPECT_THROW(PixelFilter(PixelFilterKind::Box, 0.0), std::invalid_argument);
    EXPECT_THROW(PixelFilter(PixelFilterKind::BlackmanHarris, std::nan("")),
                 std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
