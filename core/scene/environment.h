// The world around the scene: one radiance everywhere, or an equirectangular picture.
//
// The picture is laid out as in Blender: u = 1/2 - atan2(y, x) / 2 pi, v = 1/2 + asin(z) / pi
// with v = 1 at the zenith (+Z), so its centre is seen along +X. A picture is importance sampled
// by a piecewise constant table of luminance times solid angle (Pharr, Jakob and Humphreys,
// Physically Based Rendering, 12.5); a constant world by the uniform sphere.
// Directions are unit, world space, and point away from the scene. Probabilities are per unit
// solid angle.

#pragma once

#include "base/vector.h"

#include <vector>

namespace eye_render {

class TextureSet;

struct EnvironmentSettings {
    static constexpr int none = -1;

    Color3f color{0.0f};        // used without a texture
    float strength = 1.0f;      // radiance = strength times colour or texture
    int texture = none;         // equirectangular, of the texture set
    M33f texture_from_world{};  // rotation, row-vector convention
};

struct EnvironmentSample {
    V3f wi;
    Color3f radiance;
    float pdf = 0.0f;
};

class Environment {
public:
    Environment() = default;  // black
    // Keeps a pointer to `textures`, which may be null without a texture. Throws
    // std::invalid_argument for light that is negative or infinite, or a matrix that is no
    // rotation.
    Environment(const EnvironmentSettings& settings, const TextureSet* textures);

    [[nodiscard]] Color3f radiance(const V3f& direction) const;
    // u in [0,1)^2. pdf is positive for every direction that has radiance.
    [[nodiscard]] EnvironmentSample sample(const V2f& u) const;
    [[nodiscard]] float pdf(const V3f& direction) const;

    // True if it gives no light at all, and need not be sampled.
    [[nodiscard]] bool is_black() const { return mean_luminance_ <= 0.0f; }
    [[nodiscard]] bool has_table() const { return !row_cdf_.empty(); }
    // Luminance of radiance, averaged over the sphere.
    [[nodiscard]] float mean_luminance() const { return mean_luminance_; }

private:
    void build_table();
    [[nodiscard]] float density(float cell_probability, float z_extent) const;

    EnvironmentSettings settings_;
    M33f world_from_texture_;
    const TextureSet* textures_ = nullptr;
    float mean_luminance_ = 0.0f;
    int table_width_ = 0;
    int table_height_ = 0;
    // Cumulative probability: of each row; and within each row, of each cell. Both start at 0.
    std::vector<float> row_cdf_;
    std::vector<float> cell_cdf_;
};

}  // namespace eye_render
