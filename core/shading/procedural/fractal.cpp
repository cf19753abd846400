#include "shading/procedural/fractal.h"

#include "shading/procedural/octaves.h"
#include "shading/procedural/perlin.h"
#include "shading/procedural/safe_float.h"

#include <cmath>

namespace eye_render {
namespace {

template <int D>
float fbm(const Point<D>& p, const Fractal& f)
{
    const Octaves octaves = octaves_of(f.detail);
    float frequency = 1.0f;
    float amplitude = 1.0f;
    float amplitudes = 0.0f;
    float sum = 0.0f;
    for (int octave = 0; octave <= octaves.whole; ++octave) {
        sum += perlin_noise(p * frequency) * amplitude;
        amplitudes += amplitude;
        amplitude *= f.roughness;
        frequency *= f.lacunarity;
    }
    const auto result = [&f](float total, float highest) {
        return f.is_normalized ? 0.5f * total / highest + 0.5f : total;
    };
    if (octaves.part == 0.0f) {
        return result(sum, amplitudes);
    }
    const float next_sum = sum + perlin_noise(p * frequency) * amplitude;
    return blend(result(sum, amplitudes), result(next_sum, amplitudes + amplitude), octaves.part);
}

template <int D>
float multifractal(Point<D> p, const Fractal& f)
{
    const Octaves octaves = octaves_of(f.detail);
    float value = 1.0f;
    float amplitude = 1.0f;
    for (int octave = 0; octave <= octaves.whole; ++octave) {
        value *= amplitude * perlin_noise(p) + 1.0f;
        amplitude *= f.roughness;
        p = p * f.lacunarity;
    }
    if (octaves.part != 0.0f) {
        value *= octaves.part * amplitude * perlin_noise(p) + 1.0f;
    }
    return value;
}

template <int D>
float hetero_terrain(Point<D> p, const Fractal& f)
{
    const Octaves octaves = octaves_of(f.detail);
    float amplitude = f.roughness;
    float value = f.offset + perlin_noise(p);
    p = p * f.lacunarity;
    for (int octave = 1; octave <= octaves.whole; ++octave) {
        value += (perlin_noise(p) + f.offset) * amplitude * value;
        amplitude *= f.roughness;
        p = p * f.lacunarity;
    }
    if (octaves.part != 0.0f) {
        value += octaves.part * ((perlin_noise(p) + f.offset) * amplitude * value);
    }
    return value;
}

template <int D>
float hybrid_multifractal(Point<D> p, const Fractal& f)
{
    constexpr float least_weight = 0.001f;  // below it, further octaves are not seen
    const Octaves octaves = octaves_of(f.detail);
    float amplitude = 1.0f;
    float value = 0.0f;
    float weight = 1.0f;
    for (int octave = 0; weight > least_weight && octave <= octaves.whole; ++octave) {
        weight = std::min(weight, 1.0f);
        const float signal = (perlin_noise(p) + f.offset) * amplitude;
        amplitude *= f.roughness;
        value += weight * signal;
        weight *= f.gain * signal;
        p = p * f.lacunarity;
    }
    if (octaves.part != 0.0f && weight > least_weight) {
        const float signal = (perlin_noise(p) + f.offset) * amplitude;
        value += octaves.part * std::min(weight, 1.0f) * signal;
    }
    return value;
}

// Without a part of an octave, as Blender.
template <int D>
float ridged_multifractal(Point<D> p, const Fractal& f)
{
    const auto ridge = [&] {
        const float height = f.offset - std::abs(perlin_noise(p));
        return height * height;
    };
    const Octaves octaves = octaves_of(f.detail);
    float amplitude = f.roughness;
    float signal = ridge();
    float value = signal;
    for (int octave = 1; octave <= octaves.whole; ++octave) {
        p = p * f.lacunarity;
        const float weight = unit_range(signal * f.gain);
        signal = ridge() * weight;
        value += signal * amplitude;
        amplitude *= f.roughness;
    }
    return value;
}

template <int D>
float noise_of_type(const Point<D>& p, const Fractal& f)
{
    switch (f.type) {
    case FractalType::Fbm: return fbm(p, f);
    case FractalType::Multifractal: return multifractal(p, f);
    case FractalType::HybridMultifractal: return hybrid_multifractal(p, f);
    case FractalType::RidgedMultifractal: return ridged_multifractal(p, f);
    case FractalType::HeteroTerrain: return hetero_terrain(p, f);
    }
    return 0.0f;
}

}  // namespace

template <int D>
float fractal_noise(const Point<D>& p, const Fractal& fractal)
{
    return finite(noise_of_type(p, fractal));
}

template float fractal_noise(const Point<1>& p, const Fractal& fractal);
template float fractal_noise(const Point<2>& p, const Fractal& fractal);
template float fractal_noise(const Point<3>& p, const Fractal& fractal);
template float fractal_noise(const Point<4>& p, const Fractal& fractal);

}  // namespace eye_render
