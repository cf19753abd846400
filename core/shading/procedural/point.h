// A point of one to four dimensions: the textures that Blender has in each of them are written
// once, for all.

#pragma once

#include <array>
#include <cstddef>

namespace eye_render {

template <int D>
struct Point {
    std::array<float, D> coordinates{};

    float& operator[](int axis) { return coordinates[static_cast<std::size_t>(axis)]; }
    float operator[](int axis) const { return coordinates[static_cast<std::size_t>(axis)]; }

    friend Point operator+(const Point& a, const Point& b)
    {
        return of_each([&](int axis) { return a[axis] + b[axis]; });
    }
    friend Point operator-(const Point& a, const Point& b)
    {
        return of_each([&](int axis) { return a[axis] - b[axis]; });
    }
    friend Point operator*(const Point& a, float factor)
    {
        return of_each([&](int axis) { return a[axis] * factor; });
    }
    friend Point operator/(const Point& a, float divisor)
    {
        return of_each([&](int axis) { return a[axis] / divisor; });
    }

    // The point whose coordinate on each axis is function(axis).
    template <typename Function>
    [[nodiscard]] static constexpr Point of_each(const Function& function)
    {
        Point result;
        for (int axis = 0; axis < D; ++axis) {
            result.coordinates[static_cast<std::size_t>(axis)] = function(axis);
        }
        return result;
    }
};

template <int D>
[[nodiscard]] Point<D> all_axes(float value)
{
    return Point<D>::of_each([value](int) { return value; });
}

template <int D>
[[nodiscard]] float dot(const Point<D>& a, const Point<D>& b)
{
    float sum = a[0] * b[0];
    for (int axis = 1; axis < D; ++axis) {
        sum += a[axis] * b[axis];
    }
    return sum;
}

template <int D>
[[nodiscard]] Point<D> blend(const Point<D>& a, const Point<D>& b, float t)
{
    return a * (1.0f - t) + b * t;
}

}  // namespace eye_render
