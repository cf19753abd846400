// Tables over the unit interval, square and cube, with nodes on the ends and linear interpolation
// between them. The same place serves every table of one size.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace eye_render {

[[nodiscard]] constexpr float mix(float a, float b, float t) { return a + (b - a) * t; }

// Where node `i` of `Size` lies.
template <std::size_t Size>
[[nodiscard]] constexpr float node(std::size_t i)
{
    return static_cast<float>(i) / static_cast<float>(Size - 1);
}

struct Place {
    std::size_t low;  // the node before
    float t;          // and how far on to the next
};

// Below 0 counts as 0, above 1 as 1, and what is not a number as 0.
template <std::size_t Size>
[[nodiscard]] inline Place locate(float x)
{
    const float position = (x > 0.0f ? std::min(x, 1.0f) : 0.0f) * static_cast<float>(Size - 1);
    const std::size_t low = std::min(static_cast<std::size_t>(position), Size - 2);
    return {low, position - static_cast<float>(low)};
}

template <std::size_t Size>
struct Table1 {
    std::array<float, Size> at{};

    [[nodiscard]] float lookup(const Place& x) const { return mix(at[x.low], at[x.low + 1], x.t); }
};

template <std::size_t Size>
struct Table2 {
    std::array<Table1<Size>, Size> at{};

    [[nodiscard]] float lookup(const Place& y, const Place& x) const
    {
        return mix(at[y.low].lookup(x), at[y.low + 1].lookup(x), y.t);
    }
};

template <std::size_t Size>
struct Table3 {
    std::array<Table2<Size>, Size> at{};

    [[nodiscard]] float lookup(const Place& z, const Place& y, const Place& x) const
    {
        return mix(at[z.low].lookup(y, x), at[z.low + 1].lookup(y, x), z.t);
    }
};

}  // namespace eye_render
