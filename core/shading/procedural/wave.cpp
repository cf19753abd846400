#include "shading/procedural/wave.h"

#include "shading/procedural/fractal.h"
#include "shading/procedural/safe_float.h"

#include <cmath>
#include <numbers>

namespace eye_render {
namespace {

constexpr float pi = std::numbers::pi_v<float>;

[[nodiscard]] float bands(const V3f& p, WaveDirection direction)
{
    switch (direction) {
    case WaveDirection::X: return p.x * 20.0f;
    case WaveDirection::Y: return p.y * 20.0f;
    case WaveDirection::Z: return p.z * 20.0f;
    case WaveDirection::All: return (p.x + p.y + p.z) * 10.0f;
    }
    return 0.0f;
}

[[nodiscard]] float rings(const V3f& p, WaveDirection axis)
{
    V3f around = p;
    if (axis != WaveDirection::All) {
        around[static_cast<int>(axis)] = 0.0f;
    }
    return std::sqrt(around.dot(around)) * 20.0f;
}

[[nodiscard]] float profile(float phase, WaveProfile profile)
{
    const float turns = phase / (2.0f * pi);
    switch (profile) {
    case WaveProfile::Sine: return 0.5f + 0.5f * std::sin(phase - 0.5f * pi);
    case WaveProfile::Saw: return turns - std::floor(turns);
    case WaveProfile::Triangle: return std::abs(turns - std::floor(turns + 0.5f)) * 2.0f;
    }
    return 0.0f;
}

}  // namespace

float wave_texture(const V3f& p, const Wave& wave)
{
    // Whole coordinates are moved off the steps of the saw.
    const V3f place = (p + V3f(0.000001f)) * 0.999999f;
    float phase =
        wave.type == WaveType::Bands ? bands(place, wave.direction) : rings(place, wave.direction);
    phase += wave.phase_offset;
    if (wave.distortion != 0.0f) {
        const V3f noise_place = place * wave.detail_scale;
        const float noise =
            fractal_noise(Point<3>{{noise_place.x, noise_place.y, noise_place.z}},
                          {.detail = wave.detail, .roughness = wave.detail_roughness});
        phase += wave.distortion * (noise * 2.0f - 1.0f);
    }
    return finite(profile(phase, wave.profile));
}

}  // namespace eye_render
