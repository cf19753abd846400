#include "shading/procedural/voronoi_grid.h"

#include "shading/procedural/voronoi_neighbourhood.h"

namespace eye_render {
namespace {

// More than any distance.
constexpr float nothing_found = std::numeric_limits<float>::max();

template <int D>
[[nodiscard]] float length(const Point<D>& v)
{
    return std::sqrt(dot(v, v));
}

template <int D>
[[nodiscard]] float manhattan_length(const Point<D>& v)
{
    float sum = 0.0f;
    for (const float x : v.coordinates) {
        sum += std::abs(x);
    }
    return sum;
}

template <int D>
[[nodiscard]] float chebychev_length(const Point<D>& v)
{
    float longest = 0.0f;
    for (const float x : v.coordinates) {
        longest = std::max(longest, std::abs(x));
    }
    return longest;
}

template <int D>
[[nodiscard]] float minkowski_length(const Point<D>& v, float exponent)
{
    float sum = 0.0f;
    for (const float x : v.coordinates) {
        sum += std::pow(std::abs(x), exponent);
    }
    return std::pow(sum, 1.0f / exponent);
}

// function(length), the length of a vector being the metric's: chosen once, outside of loops.
template <int D, typename Function>
auto with_length(const VoronoiGrid<D>& grid, const Function& function)
{
    using Vector = Point<D>;
    if constexpr (D > 1) {  // on a line, all metrics are the same
        switch (grid.metric) {
        case VoronoiMetric::Euclidean: break;
        case VoronoiMetric::Manhattan:
            return function([](const Vector& v) { return manhattan_length(v); });
        case VoronoiMetric::Chebychev:
            return function([](const Vector& v) { return chebychev_length(v); });
        case VoronoiMetric::Minkowski:
            return function([&](const Vector& v) { return minkowski_length(v, grid.exponent); });
        }
        return function([](const Vector& v) { return length(v); });
    }
    return function([](const Vector& v) { return std::abs(v[0]); });
}

// The first of the least; the first of all if none is below `nothing_found`.
struct Nearest {
    float distance = nothing_found;
    std::size_t index = 0;

    template <typename Distances>
    explicit Nearest(const Distances& distances)
    {
        for (std::size_t i = 0; i < distances.size(); ++i) {
            if (distances[i] < distance) {
                distance = distances[i];
                index = i;
            }
        }
    }
};

}  // namespace

template <int D>
float VoronoiGrid<D>::distance(const Point<D>& a, const Point<D>& b) const
{
    return with_length(*this, [&](const auto& length_of) { return length_of(a - b); });
}

template <int D>
VoronoiPoint<D> VoronoiGrid<D>::f1(const Point<D>& p) const
{
    const CellPlace<D> place(p);
    const VoronoiNeighbourhood<D, 1> around(place, randomness);
    const Nearest nearest(with_length(
        *this, [&](const auto& length_of) { return around.distances(place.local, length_of); }));
    return {nearest.distance, random_color(place.cell + around.cell(nearest.index)),
            around.point(nearest.index) + place.cell};
}

template <int D>
VoronoiPoint<D> VoronoiGrid<D>::f2(const Point<D>& p) const
{
    const CellPlace<D> place(p);
    const VoronoiNeighbourhood<D, 1> around(place, randomness);
    auto distances = with_length(
        *this, [&](const auto& length_of) { return around.distances(place.local, length_of); });
    distances[Nearest(distances).index] = nothing_found;
    const Nearest second(distances);
    return {second.distance, random_color(place.cell + around.cell(second.index)),
            around.point(second.index) + place.cell};
}

template <int D>
VoronoiPoint<D> VoronoiGrid<D>::smooth_f1(const Point<D>& p, float smoothing) const
{
    const CellPlace<D> place(p);
    const VoronoiNeighbourhood<D, 2> around(place, randomness);
    const auto distances = with_length(
        *this, [&](const auto& length_of) { return around.distances(place.local, length_of); });
    VoronoiPoint<D> smooth;
    for (std::size_t i = 0; i < around.size; ++i) {
        const float nearer = 0.5f + 0.5f * (smooth.distance - distances[i]) / smoothing;
        const float t = i == 0 ? 1.0f : smooth_step(nearer);
        if (t > 0.0f) {
            const float correction = smoothing * t * (1.0f - t);
            const float shift = correction / (1.0f + 3.0f * smoothing);
            const V3f color = random_color(place.cell + around.cell(i));
            smooth.distance = blend(smooth.distance, distances[i], t) - correction;
            smooth.color = blend(smooth.color, color, t) - V3f(shift);
            smooth.position = blend(smooth.position, around.point(i), t) - all_axes<D>(shift);
        }
    }
    smooth.position = place.cell + smooth.position;
    return smooth;
}

template <int D>
float VoronoiGrid<D>::distance_to_edge(const Point<D>& p) const
{
    const CellPlace<D> place(p);
    const VoronoiNeighbourhood<D, 1> around(place, randomness);
    if constexpr (D == 1) {  // the neighbours are known without a search
        // As Blender, which tells cell -0 from cell 0 here alone.
        const float own = random_value(place.cell) * randomness;
        const float left = (own + around.point(0)[0]) / 2.0f;
        const float right = (own + around.point(2)[0]) / 2.0f;
        return std::min(std::abs(left - place.local[0]), std::abs(right - place.local[0]));
    }
    // Points closer together than this, squared, have no border that floats can tell.
    constexpr float least_separation2 = 0.0001f;
    const Nearest nearest(
        around.distances(place.local, [](const Point<D>& v) { return dot(v, v); }));
    const Point<D> to_nearest = around.point(nearest.index) - place.local;
    return std::ranges::min(around.distances(place.local, [&](const Point<D>& to_other) {
        const Point<D> across = to_other - to_nearest;
        const Point<D> to_middle = (to_nearest + to_other) / 2.0f;
        const float separation2 = dot(across, across);
        const float to_border = dot(to_middle, across / std::sqrt(separation2));
        return separation2 > least_separation2 ? to_border : nothing_found;
    }));
}

template <int D>
float VoronoiGrid<D>::n_sphere_radius(const Point<D>& p) const
{
    const auto euclidean = [](const Point<D>& v) { return length(v); };
    const CellPlace<D> place(p);
    const VoronoiNeighbourhood<D, 1> around(place, randomness);
    const Nearest nearest(around.distances(place.local, euclidean));

    const VoronoiNeighbourhood<D, 1> next(place, randomness, around.cell(nearest.index));
    auto distances = next.distances(around.point(nearest.index), euclidean);
    distances[distances.size() / 2] = nothing_found;  // to itself
    return std::ranges::min(distances) / 2.0f;
}

template struct VoronoiGrid<1>;
template struct VoronoiGrid<2>;
template struct VoronoiGrid<3>;
template struct VoronoiGrid<4>;

}  // namespace eye_render
