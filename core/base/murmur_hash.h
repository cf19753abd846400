// MurmurHash3, the 32-bit variant for x86 (Appleby 2011), seed 0.

#pragma once

#include <cstdint>
#include <string_view>

namespace eye_render {

[[nodiscard]] std::uint32_t murmur3_32(std::string_view text);

}  // namespace eye_render
