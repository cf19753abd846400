// How Cryptomatte tells things apart: by their names, as hashes that pass for floats.
//
// Friedman & Jones 2015, "Fully automatic ID mattes with support for motion blur and
// transparency", and the Cryptomatte specification 1.2.0.

#pragma once

#include "base/murmur_hash.h"

#include <bit>
#include <string_view>

namespace eye_render {

// Of nothing.
inline constexpr float no_matte = 0.0f;

// The hash of the name in UTF-8, its exponent held to those of ordinary numbers: files must bring
// it back bit by bit, which they need not do with NaN and denormals.
[[nodiscard]] inline float matte_id(std::string_view name)
{
    constexpr std::uint32_t exponent_bits = 0xffu << 23;
    const std::uint32_t hash = murmur3_32(name);
    const std::uint32_t exponent = (hash & exponent_bits) >> 23;
    const std::uint32_t held = exponent == 0 ? 1u : exponent == 255 ? 254u : exponent;
    return std::bit_cast<float>((hash & ~exponent_bits) | held << 23);
}

// What an object is called, and what it is part of.
struct MatteIds {
    float object = no_matte;
    float asset = no_matte;
};

}  // namespace eye_render
