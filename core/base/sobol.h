// Owen-scrambled Sobol samples in padded groups of four dimensions.
//
// Burley 2020, "Practical Hash-based Owen Scrambling" (JCGT 9(4)): the sample index is shuffled by
// a nested uniform scramble, looked up in the first four Sobol dimensions (Joe & Kuo 2008), and
// each dimension is scrambled again. The scramble is the Laine-Karras hash in Vegdahl's form
// (2021, "Building a Better LK Hash"), which has fewer visible correlations at low counts.
//
// Any aligned block of 2^k samples of one group is stratified: exactly one sample in each
// elementary interval of dimensions 0 and 1, and in each 2^-k slice of every dimension. So give
// dimensions 0 and 1 to the integral that matters most. Groups and keys are independent.
//
// A sample is a pure function of (key, sample, group): threads, tiles and splits into sample
// ranges cannot change it.

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace eye_render {

namespace detail {

// The four dimensions side by side; g++ and clang turn its operators into SIMD instructions.
using Lanes = std::uint32_t __attribute__((vector_size(16)));

// Four Sobol words (one a dimension, bit-reversed) for each value of each 4-bit digit of the
// bit-reversed index. Two kilobytes: it shares the first-level cache with the renderer's own data.
using SobolTable = std::array<std::array<Lanes, 16>, 8>;
extern const SobolTable sobol_table;

// A bijection of 64 bits that mixes every bit into every other (Stafford 2011, variant 13).
[[nodiscard]] constexpr std::uint64_t mix_bits(std::uint64_t v)
{
    v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9u;
    v = (v ^ (v >> 27)) * 0x94d049bb133111ebu;
    return v ^ (v >> 31);
}

template <typename Bits>
[[nodiscard]] constexpr Bits reverse_bits(Bits v)
{
    v = (v << 16) | (v >> 16);
    v = ((v & 0x00ff00ffu) << 8) | ((v & 0xff00ff00u) >> 8);
    v = ((v & 0x0f0f0f0fu) << 4) | ((v & 0xf0f0f0f0u) >> 4);
    v = ((v & 0x33333333u) << 2) | ((v & 0xccccccccu) >> 2);
    return ((v & 0x55555555u) << 1) | ((v & 0xaaaaaaaau) >> 1);
}

// A permutation in which a bit depends on itself and lower bits only: the nested uniform scramble
// of a bit-reversed number.
template <typename Bits>
[[nodiscard]] constexpr Bits scramble_reversed(Bits v, Bits seed)
{
    v ^= v * 0x3d20adeau;
    v += seed;
    v *= (seed >> 16) | 1u;
    v ^= v * 0x05526c56u;
    return v ^ (v * 0x53a22864u);
}

}  // namespace detail

// The key of one pixel's samples: `pixel` is its index in the full frame, whatever the border.
[[nodiscard]] constexpr std::uint64_t sobol_key(std::uint64_t seed, std::uint64_t pixel)
{
    return detail::mix_bits(detail::mix_bits(seed + 0x9e3779b97f4a7c15u) + pixel);
}

// Four numbers in [0, 1), multiples of 2^-24.
[[nodiscard]] inline std::array<float, 4> sobol_4d(std::uint64_t key,
                                                   std::uint32_t sample,
                                                   std::uint32_t group)
{
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15u;
    const std::uint64_t h = detail::mix_bits(key + golden * (group + std::uint64_t{1}));
    const std::uint64_t h01 = detail::mix_bits(h + golden);
    const std::uint64_t h23 = detail::mix_bits(h - golden);
    const detail::Lanes seeds{
        static_cast<std::uint32_t>(h01), static_cast<std::uint32_t>(h01 >> 32),
        static_cast<std::uint32_t>(h23), static_cast<std::uint32_t>(h23 >> 32)};

    // Table and hash both work on reversed bits, so only the ends of the chain are reversed.
    const std::uint32_t index =
        detail::scramble_reversed(detail::reverse_bits(sample), static_cast<std::uint32_t>(h));
    detail::Lanes bits{};
    for (std::size_t digit = 0; digit < 8; ++digit) {
        bits ^= detail::sobol_table[digit][(index >> (4 * digit)) & 15u];
    }
    bits = detail::reverse_bits(detail::scramble_reversed(bits, seeds)) >> 8;
    std::array<float, 4> u{};
    for (std::size_t i = 0; i < 4; ++i) {
        // 24 bits: what a float holds exactly, so that rounding never yields 1.
        u[i] = static_cast<float>(static_cast<std::int32_t>(bits[i])) * 0x1p-24f;
    }
    return u;
}

}  // namespace eye_render
