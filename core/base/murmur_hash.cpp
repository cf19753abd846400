#include "base/murmur_hash.h"

#include <bit>
#include <cstddef>

namespace eye_render {

namespace {

[[nodiscard]] std::uint32_t mixed(std::uint32_t block)
{
    return std::rotl(block * 0xcc9e2d51u, 15) * 0x1b873593u;
}

// `count` bytes, the first in the lowest place on every machine.
[[nodiscard]] std::uint32_t bytes_at(std::string_view text, std::size_t first, std::size_t count)
{
    std::uint32_t block = 0;
    for (std::size_t i = 0; i < count; ++i) {
        block |= static_cast<std::uint32_t>(static_cast<unsigned char>(text[first + i])) << 8 * i;
    }
    return block;
}

}  // namespace

std::uint32_t murmur3_32(std::string_view text)
{
    std::uint32_t hash = 0;
    const std::size_t whole = text.size() / 4 * 4;
    for (std::size_t i = 0; i < whole; i += 4) {
        hash = std::rotl(hash ^ mixed(bytes_at(text, i, 4)), 13) * 5u + 0xe6546b64u;
    }
    hash ^= mixed(bytes_at(text, whole, text.size() - whole));
    hash ^= static_cast<std::uint32_t>(text.size());
    hash = (hash ^ hash >> 16) * 0x85ebca6bu;
    hash = (hash ^ hash >> 13) * 0xc2b2ae35u;
    return hash ^ hash >> 16;
}

}  // namespace eye_render
