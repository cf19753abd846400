// Sums and products of Perlin noise at growing frequencies: fractional Brownian motion and the
// multifractals of Musgrave (Ebert et al. 2003, "Texturing & Modeling", ch. 16), as Blender has
// them, whose octaves need not be a whole number.

#pragma once

#include "shading/procedural/point.h"

#include <cstdint>

namespace eye_render {

enum class FractalType : std::uint8_t {
    Fbm,
    Multifractal,
    HybridMultifractal,
    RidgedMultifractal,
    HeteroTerrain,
};

struct Fractal {
    FractalType type = FractalType::Fbm;
    bool is_normalized = true;  // Fbm alone: to [0, 1]
    float detail = 2.0f;        // octaves after the first; 15 at most
    float roughness = 0.5f;     // amplitude of an octave over that of the one before
    float lacunarity = 2.0f;    // frequency of an octave over that of the one before
    float offset = 0.0f;        // not Fbm, not Multifractal
    float gain = 1.0f;          // HybridMultifractal and RidgedMultifractal
};

// Finite, whatever the input.
template <int D>
[[nodiscard]] float fractal_noise(const Point<D>& p, const Fractal& fractal);

extern template float fractal_noise(const Point<1>& p, const Fractal& fractal);
extern template float fractal_noise(const Point<2>& p, const Fractal& fractal);
extern template float fractal_noise(const Point<3>& p, const Fractal& fractal);
extern template float fractal_noise(const Point<4>& p, const Fractal& fractal);

}  // namespace eye_render
