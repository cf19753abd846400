#include "shading/procedural/perlin.h"

#include "shading/procedural/hash.h"

#include <cmath>
#include <cstdint>

namespace eye_render {
namespace {

// What brings each dimension's noise to about [-1, 1]: found by experiment by the authors of Open
// Shading Language.
constexpr std::array<float, 4> scale_of_dimension{0.25f, 0.6616f, 0.982f, 0.8344f};

// The gradients of a cell's corners, chosen by the lowest digits of the corner's hash: tables,
// since a processor cannot guess where branches on a hash go.
constexpr std::array<Point<1>, 16> gradients(Point<1> /*dimension*/)
{
    std::array<Point<1>, 16> result;
    for (std::size_t h = 0; h < result.size(); ++h) {
        const auto steepness = static_cast<float>(1 + h % 8);
        result[h] = {{h < 8 ? steepness : -steepness}};
    }
    return result;
}

constexpr std::array<Point<2>, 8> gradients(Point<2> /*dimension*/)
{
    return {
        {{{1, 2}}, {{-1, 2}}, {{1, -2}}, {{-1, -2}}, {{2, 1}}, {{2, -1}}, {{-2, 1}}, {{-2, -1}}}};
}

// To the middles of a cube's edges, four of them twice.
constexpr std::array<Point<3>, 16> gradients(Point<3> /*dimension*/)
{
    return {{{{1, 1, 0}},
             {{-1, 1, 0}},
             {{1, -1, 0}},
             {{-1, -1, 0}},
             {{1, 0, 1}},
             {{-1, 0, 1}},
             {{1, 0, -1}},
             {{-1, 0, -1}},
             {{0, 1, 1}},
             {{0, -1, 1}},
             {{0, 1, -1}},
             {{0, -1, -1}},
             {{1, 1, 0}},
             {{0, -1, 1}},
             {{-1, 1, 0}},
             {{0, -1, -1}}}};
}

// All signs of three ones and a zero.
constexpr std::array<Point<4>, 32> gradients(Point<4> /*dimension*/)
{
    constexpr std::array<std::size_t, 4> zero_axis{3, 2, 1, 0};
    std::array<Point<4>, 32> result;
    for (std::size_t h = 0; h < result.size(); ++h) {
        std::size_t digit = 0;
        for (std::size_t axis = 0; axis < 4; ++axis) {
            if (axis != zero_axis[h / 8]) {
                result[h].coordinates[axis] = ((h >> digit) & 1u) != 0 ? -1.0f : 1.0f;
                ++digit;
            }
        }
    }
    return result;
}

template <int D>
constexpr auto gradient_table = gradients(Point<D>{});

[[nodiscard]] float repeated(float x)
{
    constexpr float period = 100'000.0f;
    constexpr float far = 1'000'000.0f;
    const float distance = std::abs(x);
    if (distance < period) {
        return x;
    }
    // Floats this large are whole numbers, where the noise is 0: half a cell on it is not.
    const float correction = distance >= far ? 0.5f : 0.0f;
    return std::isfinite(x) ? std::fmod(x, period) + correction : 0.0f;
}

template <std::size_t D, std::size_t corners>
std::array<std::uint32_t, corners> hashes_of(
    const std::array<std::array<std::uint32_t, corners>, D>& cells)
{
    std::array<std::uint32_t, corners> hashes;
    for (std::size_t i = 0; i < corners; ++i) {
        if constexpr (D == 1) {
            hashes[i] = hash(cells[0][i]);
        } else if constexpr (D == 2) {
            hashes[i] = hash(cells[0][i], cells[1][i]);
        } else if constexpr (D == 3) {
            hashes[i] = hash(cells[0][i], cells[1][i], cells[2][i]);
        } else {
            hashes[i] = hash(cells[0][i], cells[1][i], cells[2][i], cells[3][i]);
        }
    }
    return hashes;
}

[[nodiscard]] float fade(float t) { return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f); }

}  // namespace

template <int D>
float perlin_noise(const Point<D>& p)
{
    // The corners of a cell are counted in binary, x being the lowest digit. Their hashes come
    // from one plain loop, which compilers turn into vector instructions.
    constexpr std::size_t corners = 1u << D;
    std::array<std::array<std::uint32_t, corners>, D> cells;
    std::array<std::array<float, corners>, D> offsets;
    std::array<float, D> local;
    for (std::size_t axis = 0; axis < D; ++axis) {
        const float x = repeated(p.coordinates[axis]);
        const int truncated = static_cast<int>(x);
        const int cell = truncated - static_cast<int>(x < static_cast<float>(truncated));
        local[axis] = x - static_cast<float>(cell);
        for (std::size_t corner = 0; corner < corners; ++corner) {
            const std::size_t side = (corner >> axis) & 1u;
            cells[axis][corner] =
                static_cast<std::uint32_t>(cell) + static_cast<std::uint32_t>(side);
            offsets[axis][corner] = local[axis] - static_cast<float>(side);
        }
    }
    const std::array<std::uint32_t, corners> hashes = hashes_of(cells);

    std::array<float, corners> values;
    constexpr auto& table = gradient_table<D>;
    for (std::size_t corner = 0; corner < corners; ++corner) {
        const Point<D>& gradient = table[hashes[corner] % table.size()];
        float slope = gradient.coordinates[0] * offsets[0][corner];
        for (std::size_t axis = 1; axis < D; ++axis) {
            slope += gradient.coordinates[axis] * offsets[axis][corner];
        }
        values[corner] = slope;
    }
    for (std::size_t axis = 0; axis < D; ++axis) {
        const float t = fade(local[axis]);
        for (std::size_t pair = 0; pair < corners >> (axis + 1); ++pair) {
            values[pair] = values[2 * pair] * (1.0f - t) + values[2 * pair + 1] * t;
        }
    }
    return scale_of_dimension[D - 1] * values[0];
}

template float perlin_noise(const Point<1>& p);
template float perlin_noise(const Point<2>& p);
template float perlin_noise(const Point<3>& p);
template float perlin_noise(const Point<4>& p);

}  // namespace eye_render
