#include "shading/procedural/voronoi.h"

#include "shading/procedural/octaves.h"
#include "shading/procedural/safe_float.h"

#include <algorithm>

namespace eye_render {
namespace {

template <int D>
VoronoiGrid<D> grid_of(const Voronoi& voronoi)
{
    return {voronoi.metric, voronoi.exponent, unit_range(voronoi.randomness)};
}

// Without roughness, further octaves weigh nothing.
[[nodiscard]] Octaves weighty_octaves(const Voronoi& voronoi)
{
    return octaves_of(voronoi.roughness > 0.0f ? voronoi.detail : 0.0f);
}

template <int D>
VoronoiPoint<D> one_octave(const Point<D>& p, const VoronoiGrid<D>& grid, const Voronoi& voronoi)
{
    const float smoothing = in_range(voronoi.smoothness / 2.0f, 0.0f, 0.5f);
    if (voronoi.feature == VoronoiFeature::F2) {
        return grid.f2(p);
    }
    if (voronoi.feature == VoronoiFeature::SmoothF1 && smoothing > 0.0f) {
        return grid.smooth_f1(p, smoothing);
    }
    return grid.f1(p);
}

// The distances and colours of the octaves add up, the position moves from each to the next.
template <int D>
VoronoiPoint<D> fractal_point(const Point<D>& p, const Voronoi& voronoi)
{
    const VoronoiGrid<D> grid = grid_of<D>(voronoi);
    const float roughness = unit_range(voronoi.roughness);
    VoronoiPoint<D> sum;
    float weights = 0.0f;
    float weight = 1.0f;
    float frequency = 1.0f;
    const auto with_next = [&] {
        const VoronoiPoint<D> octave = one_octave(p * frequency, grid, voronoi);
        return VoronoiPoint<D>{sum.distance + octave.distance * weight,
                               sum.color + octave.color * weight,
                               blend(sum.position, octave.position / frequency, weight)};
    };
    const Octaves octaves = weighty_octaves(voronoi);
    for (int octave = 0; octave <= octaves.whole; ++octave) {
        sum = with_next();
        weights += weight;
        weight *= roughness;
        frequency *= voronoi.lacunarity;
    }
    if (octaves.part > 0.0f) {
        const VoronoiPoint<D> next = with_next();
        sum = {blend(sum.distance, next.distance, octaves.part),
               blend(sum.color, next.color, octaves.part),
               blend(sum.position, next.position, octaves.part)};
        weights = blend(weights, weights + weight, octaves.part);
    }
    if (voronoi.is_normalized) {
        const Point<D> farthest = all_axes<D>(0.5f + 0.5f * grid.randomness);
        const float points = voronoi.feature == VoronoiFeature::F2 ? 2.0f : 1.0f;
        sum.distance /= weights * (grid.distance({}, farthest) * points);
        sum.color = sum.color / weights;
    }
    return sum;
}

// The edges of each octave come nearer than those before by its weight.
template <int D>
float fractal_distance_to_edge(const Point<D>& p, const Voronoi& voronoi)
{
    constexpr float no_edge = 8.0f;  // more than any distance
    const VoronoiGrid<D> grid = grid_of<D>(voronoi);
    const float roughness = unit_range(voronoi.roughness);
    const float farthest = 0.5f + 0.5f * grid.randomness;
    float most = farthest;
    float distance = no_edge;
    float weight = 1.0f;
    float frequency = 1.0f;
    const auto nearer_by_next = [&] {
        const float octave = grid.distance_to_edge(p * frequency) / frequency;
        return blend(distance, std::min(distance, octave), weight);
    };
    const Octaves octaves = weighty_octaves(voronoi);
    for (int octave = 0; octave <= octaves.whole; ++octave) {
        distance = nearer_by_next();
        most = blend(most, farthest / frequency, weight);
        weight *= roughness;
        frequency *= voronoi.lacunarity;
    }
    if (octaves.part > 0.0f) {
        distance = blend(distance, std::min(distance, nearer_by_next()), octaves.part);
        most = blend(most, blend(most, farthest / frequency, weight), octaves.part);
    }
    return voronoi.is_normalized ? distance / most : distance;
}

void set_position(VoronoiAnswer& answer, const Point<1>& p) { answer.w = p[0]; }
void set_position(VoronoiAnswer& answer, const Point<2>& p)
{
    answer.position = {p[0], p[1], 0.0f};
}
void set_position(VoronoiAnswer& answer, const Point<3>& p)
{
    answer.position = {p[0], p[1], p[2]};
}
void set_position(VoronoiAnswer& answer, const Point<4>& p)
{
    answer.position = {p[0], p[1], p[2]};
    answer.w = p[3];
}

template <int D>
VoronoiAnswer answer_to(const Point<D>& p, const Voronoi& voronoi)
{
    VoronoiAnswer answer;
    if (voronoi.feature == VoronoiFeature::DistanceToEdge) {
        answer.distance = fractal_distance_to_edge(p * voronoi.scale, voronoi);
    } else if (voronoi.feature == VoronoiFeature::NSphereRadius) {
        answer.radius = grid_of<D>(voronoi).n_sphere_radius(p * voronoi.scale);
    } else {
        const VoronoiPoint<D> point = fractal_point(p * voronoi.scale, voronoi);
        answer.distance = point.distance;
        answer.color = point.color;
        if (voronoi.scale != 0.0f) {
            set_position(answer, point.position / voronoi.scale);
        }
    }
    return answer;
}

}  // namespace

template <int D>
VoronoiAnswer voronoi_texture(const Point<D>& p, const Voronoi& voronoi)
{
    const VoronoiAnswer answer = answer_to(p, voronoi);
    return {finite(answer.distance), finite(answer.color), finite(answer.position),
            finite(answer.w), finite(answer.radius)};
}

template VoronoiAnswer voronoi_texture(const Point<1>& p, const Voronoi& voronoi);
template VoronoiAnswer voronoi_texture(const Point<2>& p, const Voronoi& voronoi);
template VoronoiAnswer voronoi_texture(const Point<3>& p, const Voronoi& voronoi);
template VoronoiAnswer voronoi_texture(const Point<4>& p, const Voronoi& voronoi);

}  // namespace eye_render
