// The table of the first four Sobol dimensions, made at compile time from Joe & Kuo's direction
// numbers (new-joe-kuo-6.21201).

#include "base/sobol.h"

namespace eye_render::detail {

namespace {

// A primitive polynomial over GF(2), its inner coefficients as bits, and the first odd numbers m.
struct Direction {
    unsigned degree;
    std::uint32_t inner_coefficients;
    std::array<std::uint32_t, 3> m;
};

// Dimension 0 is the van der Corput sequence and has no polynomial.
constexpr std::array<Direction, 3> directions{{
    {1, 0, {1, 0, 0}},
    {2, 1, {1, 3, 0}},
    {3, 1, {1, 3, 1}},
}};

using Columns = std::array<std::uint32_t, 32>;

// The 32 columns of a dimension's generator matrix, most significant bit first.
constexpr Columns generator_columns(std::size_t dimension)
{
    Columns v{};
    if (dimension == 0) {
        for (unsigned k = 0; k < 32; ++k) {
            v[k] = 1u << (31 - k);
        }
        return v;
    }
    const Direction& d = directions[dimension - 1];
    for (unsigned k = 0; k < 32; ++k) {
        if (k < d.degree) {
            v[k] = d.m[k] << (31 - k);
            continue;
        }
        v[k] = v[k - d.degree] ^ (v[k - d.degree] >> d.degree);
        for (unsigned j = 1; j < d.degree; ++j) {
            if ((d.inner_coefficients >> (d.degree - 1 - j)) & 1u) {
                v[k] ^= v[k - j];
            }
        }
    }
    return v;
}

constexpr std::uint32_t table_word(const Columns& columns, unsigned digit, unsigned value)
{
    std::uint32_t word = 0;
    for (unsigned bit = 0; bit < 4; ++bit) {
        if ((value >> bit) & 1u) {
            // Bit i of the reversed index is bit 31 - i of the index.
            word ^= columns[31 - (4 * digit + bit)];
        }
    }
    return reverse_bits(word);
}

constexpr SobolTable make_table()
{
    const std::array<Columns, 4> columns{generator_columns(0), generator_columns(1),
                                         generator_columns(2), generator_columns(3)};
    SobolTable table{};
    for (unsigned digit = 0; digit < 8; ++digit) {
        for (unsigned value = 0; value < 16; ++value) {
            table[digit][value] =
                Lanes{table_word(columns[0], digit, value), table_word(columns[1], digit, value),
                      table_word(columns[2], digit, value), table_word(columns[3], digit, value)};
        }
    }
    return table;
}

}  // namespace

constinit const SobolTable sobol_table = make_table();

}  // namespace eye_render::detail
