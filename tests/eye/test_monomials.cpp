#include "eye/monomials.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace eye_render {
namespace {

// The variables are primes, so that every product is another number.
TEST(Monomials, are_all_products_of_powers_once_in_order_of_degree)
{
    constexpr std::size_t degree = 5;
    const auto two = monomials<degree>(2.0, 3.0);
    const auto three = monomials<degree>(2.0, 3.0, 5.0);
    std::size_t next_of_two = 0;
    std::size_t next_of_three = 0;
    for (std::size_t d = 0; d <= degree; ++d) {
        std::vector<double> expected_two;
        std::vector<double> expected_three;
        for (std::size_t a = 0; a <= d; ++a) {
            for (std::size_t b = 0; a + b <= d; ++b) {
                const double product = std::pow(2.0, double(a)) * std::pow(3.0, double(b));
                expected_three.push_back(product * std::pow(5.0, double(d - a - b)));
                if (a + b == d) expected_two.push_back(product);
            }
        }
        const auto expect_block = [&](const auto& all, std::size_t& next, auto& expected) {
            std::vector<double> block(all.begin() + std::ptrdiff_t(next),
                                      all.begin() + std::ptrdiff_t(next + expected.size()));
            std::ranges::sort(block);
            std::ranges::sort(expected);
            EXPECT_EQ(block, expected) << "degree " << d;
            next += expected.size();
        };
        expect_block(two, next_of_two, expected_two);
        expect_block(three, next_of_three, expected_three);
    }
    EXPECT_EQ(next_of_two, two.size());
    EXPECT_EQ(next_of_three, three.size());
}

}  // namespace
}  // namespace eye_render
