// The random points of the cells around a place. They are kept by coordinate and computed in plain
// loops, which compilers turn into vector instructions: most of a Voronoi texture's time is here.

#pragma once

#include "shading/procedural/hash.h"
#include "shading/procedural/point.h"
#include "shading/procedural/safe_float.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

// A place as its cell and where it lies in it; a coordinate that is not finite counts as 0.
template <int D>
struct CellPlace {
    Point<D> cell;
    Point<D> local;

    explicit CellPlace(const Point<D>& p)
    {
        for (int axis = 0; axis < D; ++axis) {
            const float x = finite(p[axis]);
            cell[axis] = std::floor(x);
            local[axis] = x - cell[axis];
        }
    }
};

[[nodiscard]] constexpr std::size_t power(std::size_t base, std::size_t exponent)
{
    return exponent == 0 ? 1 : base * power(base, exponent - 1);
}

// All cells from -reach to reach, in Blender's order, the first axis fastest: where points are
// equally far, and in the smooth variant everywhere, the order decides.
template <int D, int reach>
class VoronoiNeighbourhood {
public:
    static constexpr std::size_t size = power(2 * reach + 1, D);
    using Distances = std::array<float, size>;

    // Cells and points are relative to the place's cell; `center` moves the whole.
    VoronoiNeighbourhood(const CellPlace<D>& place,
                         float randomness,
                         const Point<D>& center = Point<D>{})
        : center_(center)
    {
        for (std::size_t i = 0; i < size; ++i) {
            const Point<D> neighbour = cell(i);
            const Point<D> point = neighbour + random_point(place.cell + neighbour) * randomness;
            for (std::size_t axis = 0; axis < D; ++axis) {
                points_[axis][i] = point.coordinates[axis];
            }
        }
    }

    [[nodiscard]] Point<D> cell(std::size_t i) const { return at(cells_, i) + center_; }
    [[nodiscard]] Point<D> point(std::size_t i) const { return at(points_, i); }

    // length(point - p) of each.
    template <typename Length>
    [[nodiscard]] Distances distances(const Point<D>& p, const Length& length) const
    {
        Distances result;
        for (std::size_t i = 0; i < size; ++i) {
            result[i] = length(point(i) - p);
        }
        return result;
    }

private:
    using Coordinates = std::array<std::array<float, size>, D>;

    static constexpr Coordinates cells_ = [] {
        Coordinates cells{};
        for (std::size_t axis = 0; axis < D; ++axis) {
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t digit = i / power(2 * reach + 1, axis) % (2 * reach + 1);
                cells[axis][i] = static_cast<float>(digit) - reach;
            }
        }
        return cells;
    }();

    [[nodiscard]] static Point<D> at(const Coordinates& coordinates, std::size_t i)
    {
        return Point<D>::of_each(
            [&](int axis) { return coordinates[static_cast<std::size_t>(axis)][i]; });
    }

    Point<D> center_;
    Coordinates points_;
};

}  // namespace eye_render
