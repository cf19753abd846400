// Blender's Gabor Texture: noise that is a sum of waves under Gaussian envelopes, strewn at
// random. Lagae, Lefebvre, Drettakis & Dutré 2009, "Procedural Noise using Sparse Gabor
// Convolution", with as many impulses a cell and weights of either sign as Tavernier, Neyret,
// Vergne & Thollot 2019, "Making Gabor Noise Fast and Normalized", and the phase and intensity of
// Tricard, Efremov, Zanni, Neyret, Martínez & Lefebvre 2019, "Procedural Phasor Noise".

#pragma once

#include "base/vector.h"
#include "shading/procedural/point.h"

namespace eye_render {

struct Gabor {
    float frequency = 2.0f;   // waves a unit
    float anisotropy = 1.0f;  // 0: waves of any direction, 1: all of the one that is given
};

// Each about [0, 1].
struct GaborAnswer {
    float value = 0.5f;
    float phase = 0.5f;  // turns, from minus half a turn
    float intensity = 0.0f;
};

// `p` is already scaled.
[[nodiscard]] GaborAnswer gabor_texture(const Point<2>& p,
                                        const Gabor& gabor,
                                        float direction_rad);
// `direction` of any length.
[[nodiscard]] GaborAnswer gabor_texture(const Point<3>& p,
                                        const Gabor& gabor,
                                        const V3f& direction);

}  // namespace eye_render
