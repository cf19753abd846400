#include "optics/root.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(BracketedRoot, is_found_to_the_last_bits_at_either_slope)
{
    for (const double sign : {1.0, -1.0}) {
        const auto root = bracketed_root([&](double x) { return sign * (x * x - 2.0); }, 0.0, 2.0);
        ASSERT_TRUE(root.has_value());
        EXPECT_NEAR(*root, std::sqrt(2.0), 1e-15);
    }
}

TEST(BracketedRoot, may_be_an_end)
{
    const auto identity = [](double x) { return x; };
    EXPECT_EQ(bracketed_root(identity, 0.0, 1.0), 0.0);
    EXPECT_EQ(bracketed_root(identity, -1.0, 0.0), 0.0);
}

TEST(BracketedRoot, does_not_lose_the_sign_of_tiny_values)
{
    EXPECT_TRUE(
        bracketed_root([](double x) { return x < 0.5 ? -5e-324 : 0.25; }, 0.0, 1.0).has_value());
}

TEST(BracketedRoot, is_nothing_without_a_change_of_sign)
{
    EXPECT_FALSE(bracketed_root([](double x) { return x * x + 1.0; }, -1.0, 1.0).has_value());
    EXPECT_FALSE(bracketed_root([](double) { return NAN; }, -1.0, 1.0).has_value());
}

}  // namespace
}  // namespace eye_render
