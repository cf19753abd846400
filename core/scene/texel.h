// Arithmetic on texels: channels, alpha, the sRGB curve and texture coordinates.

#pragma once

#include "base/vector.h"
#include "scene/texture_options.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace eye_render {

// IEC 61966-2-1; values above 1 follow the same curve.
[[nodiscard]] inline float linear_from_srgb(float c)
{
    return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f);
}

[[nodiscard]] inline Color3f linear_from_srgb(const Color3f& c)
{
    return {linear_from_srgb(c.x), linear_from_srgb(c.y), linear_from_srgb(c.z)};
}

// Multiplies alpha into the encoded colour of RGBA pixels; whole numbers are rounded down, as
// Cycles does.
inline void associate(std::uint8_t* rgba, std::size_t pixels)
{
    for (std::uint8_t* p = rgba; p != rgba + 4 * pixels; p += 4) {
        for (int c = 0; c < 3; ++c) {
            p[c] = static_cast<std::uint8_t>(p[c] * p[3] / 255);
        }
    }
}

inline void associate(float* rgba, std::size_t pixels)
{
    for (float* p = rgba; p != rgba + 4 * pixels; p += 4) {
        for (int c = 0; c < 3; ++c) {
            p[c] *= p[3];
        }
    }
}

// From `channels` interleaved values to RGBA: grey is spread out, missing alpha is opaque.
template <typename T>
void expand_to_rgba(const T* in, int channels, T opaque, T* out, std::size_t pixels)
{
    const bool gray = channels < 3;
    const int alpha = channels == 2 ? 1 : channels > 3 ? 3 : -1;
    for (std::size_t i = 0; i < pixels; ++i, in += channels, out += 4) {
        for (int c = 0; c < 3; ++c) {
            out[c] = in[gray ? 0 : c];
        }
        out[3] = alpha < 0 ? opaque : in[alpha];
    }
}

// Of the four texels around a place, t of the way from the second to the third: the uniform cubic
// B-spline.
[[nodiscard]] inline std::array<float, 4> cubic_weights(float t)
{
    const float s = 1.0f - t;
    return {s * s * s / 6.0f, (4.0f + 3.0f * t * t * (t - 2.0f)) / 6.0f,
            (4.0f + 3.0f * s * s * (s - 2.0f)) / 6.0f, t * t * t / 6.0f};
}

// How much of the interpolation's footprint lies on an axis of `size` texels, at `x` texels.
[[nodiscard]] inline float coverage(float x, int size, Interpolation interpolation)
{
    const auto width = static_cast<float>(size);
    switch (interpolation) {
    case Interpolation::Closest: return x >= 0.0f && x < width ? 1.0f : 0.0f;
    case Interpolation::Cubic: break;
    case Interpolation::Linear:
        return std::clamp(x + 0.5f, 0.0f, 1.0f) * std::clamp(width + 0.5f - x, 0.0f, 1.0f);
    }
    const float first = std::floor(x - 0.5f) - 1.0f;
    const std::array<float, 4> weights = cubic_weights(x - 0.5f - std::floor(x - 0.5f));
    float sum = 0.0f;
    for (std::size_t i = 0; i < weights.size(); ++i) {
        const float texel = first + static_cast<float>(i);
        sum += texel >= 0.0f && texel < width ? weights[i] : 0.0f;
    }
    return sum;
}

// Brings a texture coordinate to where float can still tell texels apart, without changing what is
// seen.
[[nodiscard]] inline float reduce_coordinate(float x, Extension extension)
{
    return extension == Extension::Repeat ? x - std::floor(x) : std::clamp(x, -1.0f, 2.0f);
}

}  // namespace eye_render
