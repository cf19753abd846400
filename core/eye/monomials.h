// Monomials of two and three variables, and where to sample functions that are fitted by them.

#pragma once

#include "base/units.h"
#include "base/vector.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace eye_render {

inline constexpr std::size_t monomials_of_two(std::size_t degree)
{
    return (degree + 1) * (degree + 2) / 2;
}

inline constexpr std::size_t monomials_of_three(std::size_t degree)
{
    return (degree + 1) * (degree + 2) * (degree + 3) / 6;
}

// All x^a y^b up to a degree, block by block of one degree, so that lower degrees are a prefix:
// the block before times x, then y^degree.
template <std::size_t Degree>
[[nodiscard]] std::array<double, monomials_of_two(Degree)> monomials(double x, double y)
{
    std::array<double, monomials_of_two(Degree)> m{};
    m[0] = 1.0;
    for (std::size_t degree = 1, before = 0, next = 1; degree <= Degree; ++degree) {
        const std::size_t begin = next;
        for (std::size_t i = before; i < begin; ++i) m[next++] = m[i] * x;
        m[next++] = m[begin - 1] * y;
        before = begin;
    }
    return m;
}

// All x^a y^b z^c likewise: the block before times x, those of it without x (its last ones) times
// y, then z^degree.
template <std::size_t Degree>
[[nodiscard]] std::array<double, monomials_of_three(Degree)> monomials(double x,
                                                                       double y,
                                                                       double z)
{
    std::array<double, monomials_of_three(Degree)> m{};
    m[0] = 1.0;
    for (std::size_t degree = 1, before = 0, next = 1; degree <= Degree; ++degree) {
        const std::size_t begin = next;
        for (std::size_t i = before; i < begin; ++i) m[next++] = m[i] * x;
        for (std::size_t i = begin - degree; i < begin; ++i) m[next++] = m[i] * y;
        m[next++] = m[begin - 1] * z;
        before = begin;
    }
    return m;
}

// The i-th of `count` radii between 0 and 1: dense towards the rim like Chebyshev's points,
// because there a polynomial fitted to evenly spread points goes astray.
[[nodiscard]] inline double fitting_radius(std::size_t i, std::size_t count)
{
    return std::sin(0.5 * pi * (static_cast<double>(i) + 0.7) / static_cast<double>(count));
}

// A point of a sector from the x axis to `range_rad`: the i-th of `count` angles.
[[nodiscard]] inline V2d fitting_point(double radius,
                                       double range_rad,
                                       std::size_t i,
                                       std::size_t count)
{
    const double angle_rad =
        range_rad * (static_cast<double>(i) + 0.5) / static_cast<double>(count);
    return {radius * std::cos(angle_rad), radius * std::sin(angle_rad)};
}

}  // namespace eye_render
