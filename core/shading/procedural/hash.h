// Hashes of whole numbers and of floats: Bob Jenkins' lookup3 (2006, public domain,
// burtleburtle.net/bob/c/lookup3.c) of one to four words, as Blender seeds it.

#pragma once

#include "base/vector.h"
#include "shading/procedural/point.h"

#include <array>
#include <bit>
#include <cstdint>
#include <tuple>

namespace eye_render {

namespace lookup3 {

struct State {
    std::uint32_t a, b, c;

    constexpr void mix()
    {
        a = (a - c) ^ std::rotl(c, 4);
        c += b;
        b = (b - a) ^ std::rotl(a, 6);
        a += c;
        c = (c - b) ^ std::rotl(b, 8);
        b += a;
        a = (a - c) ^ std::rotl(c, 16);
        c += b;
        b = (b - a) ^ std::rotl(a, 19);
        a += c;
        c = (c - b) ^ std::rotl(b, 4);
        b += a;
    }

    constexpr void finish()
    {
        c = (c ^ b) - std::rotl(b, 14);
        a = (a ^ c) - std::rotl(c, 11);
        b = (b ^ a) - std::rotl(a, 25);
        c = (c ^ b) - std::rotl(b, 16);
        a = (a ^ c) - std::rotl(c, 4);
        b = (b ^ a) - std::rotl(a, 14);
        c = (c ^ b) - std::rotl(b, 24);
    }
};

// The state before any word is added; lookup3 starts with the message's length in bytes.
constexpr State start(std::uint32_t words)
{
    const std::uint32_t initial = 0xdeadbeefu + 4u * words + 13u;
    return {initial, initial, initial};
}

}  // namespace lookup3

[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t x)
{
    lookup3::State state = lookup3::start(1);
    state.a += x;
    state.finish();
    return state.c;
}

[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y)
{
    lookup3::State state = lookup3::start(2);
    state.a += x;
    state.b += y;
    state.finish();
    return state.c;
}

[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t x, std::uint32_t y, std::uint32_t z)
{
    lookup3::State state = lookup3::start(3);
    state.a += x;
    state.b += y;
    state.c += z;
    state.finish();
    return state.c;
}

[[nodiscard]] constexpr std::uint32_t hash(std::uint32_t x,
                                           std::uint32_t y,
                                           std::uint32_t z,
                                           std::uint32_t w)
{
    lookup3::State state = lookup3::start(4);
    state.a += x;
    state.b += y;
    state.c += z;
    state.mix();
    state.a += w;
    state.finish();
    return state.c;
}

// In [0, 1], from the bits of one to four floats: -0 and 0 differ.
template <typename... Floats>
[[nodiscard]] constexpr float unit_hash(Floats... keys)
{
    return static_cast<float>(hash(std::bit_cast<std::uint32_t>(keys)...)) * 0x1p-32f;
}

// The hashes of a point's own coordinates and of these followed by 1, 2, …
template <int Channels>
[[nodiscard]] Point<Channels> unit_hashes(const Point<1>& p)
{
    return Point<Channels>::of_each([&](int channel) {
        return channel == 0 ? unit_hash(p[0]) : unit_hash(p[0], static_cast<float>(channel));
    });
}
template <int Channels>
[[nodiscard]] Point<Channels> unit_hashes(const Point<2>& p)
{
    return Point<Channels>::of_each([&](int channel) {
        return channel == 0 ? unit_hash(p[0], p[1])
                            : unit_hash(p[0], p[1], static_cast<float>(channel));
    });
}
template <int Channels>
[[nodiscard]] Point<Channels> unit_hashes(const Point<3>& p)
{
    return Point<Channels>::of_each([&](int channel) {
        return channel == 0 ? unit_hash(p[0], p[1], p[2])
                            : unit_hash(p[0], p[1], p[2], static_cast<float>(channel));
    });
}

// A random value for a point, and a random point and a random colour that do not depend on each
// other more than Blender's do.
template <int D>
[[nodiscard]] float random_value(const Point<D>& p)
{
    return std::apply([](auto... keys) { return unit_hash(keys...); }, p.coordinates);
}

template <int D>
[[nodiscard]] Point<D> random_point(const Point<D>& p)
{
    return unit_hashes<D>(p);
}
template <>
[[nodiscard]] inline Point<4> random_point(const Point<4>& p)
{
    return {{unit_hash(p[0], p[1], p[2], p[3]), unit_hash(p[3], p[0], p[1], p[2]),
             unit_hash(p[2], p[3], p[0], p[1]), unit_hash(p[1], p[2], p[3], p[0])}};
}

template <int D>
[[nodiscard]] V3f random_color(const Point<D>& p)
{
    const Point<3> channels = unit_hashes<3>(p);
    return {channels[0], channels[1], channels[2]};
}
template <>
[[nodiscard]] inline V3f random_color(const Point<4>& p)
{
    return {unit_hash(p[0], p[1], p[2], p[3]), unit_hash(p[2], p[0], p[3], p[1]),
            unit_hash(p[3], p[2], p[1], p[0])};
}

}  // namespace eye_render
