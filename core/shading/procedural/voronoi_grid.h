// The random points of a Voronoi texture, one in each cell of a grid, and which of them are near:
// one octave. Places and distances are in cells.

#pragma once

#include "base/vector.h"
#include "shading/procedural/point.h"

#include <cstdint>

namespace eye_render {

enum class VoronoiMetric : std::uint8_t { Euclidean, Manhattan, Chebychev, Minkowski };

template <int D>
struct VoronoiPoint {
    float distance = 0.0f;
    V3f color{0.0f};
    Point<D> position;
};

template <int D>
struct VoronoiGrid {
    VoronoiMetric metric = VoronoiMetric::Euclidean;
    float exponent = 0.5f;    // Minkowski's
    float randomness = 1.0f;  // from 0, points at their cells' corners, to 1, anywhere in them

    [[nodiscard]] float distance(const Point<D>& a, const Point<D>& b) const;

    // The nearest point, and the next.
    [[nodiscard]] VoronoiPoint<D> f1(const Point<D>& p) const;
    [[nodiscard]] VoronoiPoint<D> f2(const Point<D>& p) const;

    // The nearest points, blended where they are about as far; `smoothing` in (0, 0.5].
    [[nodiscard]] VoronoiPoint<D> smooth_f1(const Point<D>& p, float smoothing) const;

    // To the border between the regions of two points (Quilez 2012, "Voronoi edges"), Euclidean.
    [[nodiscard]] float distance_to_edge(const Point<D>& p) const;

    // Half the distance from the nearest point to the one nearest to that, Euclidean.
    [[nodiscard]] float n_sphere_radius(const Point<D>& p) const;
};

extern template struct VoronoiGrid<1>;
extern template struct VoronoiGrid<2>;
extern template struct VoronoiGrid<3>;
extern template struct VoronoiGrid<4>;

}  // namespace eye_render
