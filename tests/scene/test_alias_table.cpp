#include "scene/alias_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

const std::vector<double> skewed = {0.0, 1e-6, 1.0, 5.0, 1000.0, 0.3, 7.0, 2.0};

TEST(AliasTable, columns_hold_each_choice_s_probability)
{
    const auto table = make_alias_table(skewed);
    double total = 0.0;
    for (const double weight : skewed) {
        total += weight;
    }
    std::vector<double> held(skewed.size(), 0.0);
    for (std::size_t i = 0; i < table.size(); ++i) {
        held[i] += static_cast<double>(table[i].keep);
        held[table[i].alias] += 1.0 - static_cast<double>(table[i].keep);
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        // `keep` is a float.
        EXPECT_NEAR(held[i] / static_cast<double>(table.size()), skewed[i] / total, 1e-7) << i;
        EXPECT_FLOAT_EQ(table[i].probability, static_cast<float>(skewed[i] / total)) << i;
    }
}

TEST(AliasTable, evenly_spread_numbers_choose_as_the_columns_say)
{
    const auto table = make_alias_table(skewed);
    constexpr int count = 1 << 20;
    std::vector<int> chosen(skewed.size(), 0);
    for (int i = 0; i < count; ++i) {
        ++chosen[choose_from(table, (i + 0.5) / count)];
    }
    for (std::size_t i = 0; i < table.size(); ++i) {
        // Each of the column's ends, and of its aliases', misplaces one number at most.
        EXPECT_NEAR(chosen[i], count * static_cast<double>(table[i].probability), 16.0) << i;
    }
}

TEST(AliasTable, numbers_beyond_the_interval_count_as_its_ends)
{
    const auto table = make_alias_table(std::vector<double>{1.0, 1.0});
    EXPECT_EQ(choose_from(table, -1e-9), 0u);
    EXPECT_EQ(choose_from(table, 1.0 + 1e-9), 1u);
}

TEST(AliasTable, one_choice_is_always_made)
{
    const auto table = make_alias_table(std::vector<double>{3.0});
    EXPECT_EQ(choose_from(table, 0.0), 0u);
    EXPECT_EQ(choose_from(table, std::nextafter(1.0, 0.0)), 0u);
    EXPECT_EQ(table[0].probability, 1.0f);
}

}  // namespace
}  // namespace eye_render
