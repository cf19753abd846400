// Blender's Wave Texture: bands or rings, bent by fractal noise.

#pragma once

#include "base/vector.h"

#include <cstdint>

namespace eye_render {

enum class WaveType : std::uint8_t { Bands, Rings };
enum class WaveProfile : std::uint8_t { Sine, Saw, Triangle };
// Of bands, the way they follow each other; of rings, the axis they are around. The last is
// diagonal bands or spherical rings.
enum class WaveDirection : std::uint8_t { X, Y, Z, All };

struct Wave {
    WaveType type = WaveType::Bands;
    WaveDirection direction = WaveDirection::X;
    WaveProfile profile = WaveProfile::Sine;
    float distortion = 0.0f;  // rad
    float detail = 2.0f;      // of the noise that distorts
    float detail_scale = 1.0f;
    float detail_roughness = 0.5f;
    float phase_offset = 0.0f;  // rad
};

// In [0, 1]; `p` is already scaled. A unit holds 20 rad of a wave.
[[nodiscard]] float wave_texture(const V3f& p, const Wave& wave);

}  // namespace eye_render
