#include "optics/least_squares.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(LeastSquares, solves_a_square_system_exactly)
{
    // Columns and unknowns of very different sizes.
    const auto x = least_squares(2, {1.0, 1e6, 2.0, -1e6}, {5.0, 1.0});
    EXPECT_NEAR(x[0], 2.0, 1e-14);
    EXPECT_NEAR(x[1], 3e-6, 1e-20);
}

TEST(LeastSquares, fits_the_line_of_a_textbook)
{
    // y = a + b x through (0, 1), (1, 3), (2, 4), (3, 4): the normal equations 4a + 6b = 12,
    // 6a + 14b = 23 give a = 1.5, b = 1.
    const auto x =
        least_squares(2, {1.0, 0.0, 1.0, 1.0, 1.0, 2.0, 1.0, 3.0}, {1.0, 3.0, 4.0, 4.0});
    EXPECT_NEAR(x[0], 1.5, 1e-14);
    EXPECT_NEAR(x[1], 1.0, 1e-14);
}

TEST(LeastSquares, leaves_what_the_rows_do_not_determine_at_zero)
{
    const auto x =
        least_squares(3, {1.0, 2.0, 0.0, 2.0, 4.0, 0.0, 1.0, 2.0, 0.0}, {3.0, 6.0, 3.0});
    EXPECT_NEAR(x[0], 3.0, 1e-14);
    EXPECT_EQ(x[1], 0.0);
    EXPECT_EQ(x[2], 0.0);
}

}  // namespace
}  // namespace eye_render
