// Blender's Voronoi Texture: every cell of a grid holds one random point (Worley 1996, "A Cellular
// Texture Basis Function"), and the texture tells of those nearest, in octaves if so wanted.

#pragma once

#include "base/vector.h"
#include "shading/procedural/voronoi_grid.h"

#include <cstdint>

namespace eye_render {

enum class VoronoiFeature : std::uint8_t { F1, F2, SmoothF1, DistanceToEdge, NSphereRadius };

struct Voronoi {
    VoronoiFeature feature = VoronoiFeature::F1;
    VoronoiMetric metric = VoronoiMetric::Euclidean;
    float exponent = 0.5f;       // Minkowski's
    float randomness = 1.0f;     // 0 to 1
    bool is_normalized = false;  // distance and colour to [0, 1]; not NSphereRadius
    float scale = 5.0f;          // cells per unit
    float detail = 0.0f;         // octaves after the first; 15 at most
    float roughness = 0.5f;      // weight of an octave over that of the one before; 0 to 1
    float lacunarity = 2.0f;     // frequency of an octave over that of the one before
    float smoothness = 1.0f;     // of SmoothF1; 0 to 1
};

// What the feature has; the rest is 0.
struct VoronoiAnswer {
    float distance = 0.0f;  // in cells
    V3f color{0.0f};
    V3f position{0.0f};  // as the coordinates before scaling, w apart
    float w = 0.0f;
    float radius = 0.0f;  // in cells
};

// `p` is not scaled yet. Finite, whatever the input. One dimension is w.
template <int D>
[[nodiscard]] VoronoiAnswer voronoi_texture(const Point<D>& p, const Voronoi& voronoi);

extern template VoronoiAnswer voronoi_texture(const Point<1>& p, const Voronoi& voronoi);
extern template VoronoiAnswer voronoi_texture(const Point<2>& p, const Voronoi& voronoi);
extern template VoronoiAnswer voronoi_texture(const Point<3>& p, const Voronoi& voronoi);
extern template VoronoiAnswer voronoi_texture(const Point<4>& p, const Voronoi& voronoi);

}  // namespace eye_render
