// Choosing one of many by weight in constant time: the alias method of Vose 1991, "A Linear
// Algorithm for Generating Random Numbers with a Given Distribution". A table has a column for
// each choice, all of equal width and each shared by at most two of them.

#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace eye_render {

struct AliasColumn {
    std::uint32_t alias = 0;   // whom the rest of the column belongs to
    float keep = 1.0f;         // share of the column that is its own
    float probability = 0.0f;  // of this choice, over the whole table
};

// The weights are not negative and their sum is positive.
[[nodiscard]] std::vector<AliasColumn> make_alias_table(std::span<const double> weights);

// The choice for u in [0, 1); a u beyond counts as the nearest. A double, because what is left of
// u within one of 10^5 columns decides between two choices.
[[nodiscard]] std::uint32_t choose_from(std::span<const AliasColumn> table, double u);

}  // namespace eye_render
