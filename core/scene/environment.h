// The world around the scene: a shader program of the direction.
//
// A world that is the same everywhere is sampled by the uniform sphere, another by a table of its
// luminance, and the sun of a sky by its cone. Directions are unit, world space, and point away
// from the scene. Probabilities are per unit solid angle.

#pragma once

#include "scene/direction_table.h"
#include "scene/scene_frame.h"
#include "shading/material.h"
#include "shading/sky.h"

#include <optional>

namespace eye_render {

struct EnvironmentSample {
    V3f wi;
    Color3f radiance;
    float pdf = 0.0f;
};

class Environment {
public:
    Environment() = default;  // black
    // Refers to world and frame, which must outlive it.
    Environment(const Material& world,
                const SceneFrame& frame,
                const std::optional<SunDisc>& sun = std::nullopt);

    // As the path sees it: a world may look at the path.
    [[nodiscard]] Color3f radiance(const V3f& direction, const PathState& path) const;
    // u in [0,1)^2. pdf is positive for every direction that has radiance. The radiance is that
    // of light that falls on a surface.
    [[nodiscard]] EnvironmentSample sample(const V2f& u) const;
    [[nodiscard]] float pdf(const V3f& direction) const;

    // True if it gives no light at all, and need not be sampled.
    [[nodiscard]] bool is_black() const { return mean_luminance_ <= 0.0f; }
    [[nodiscard]] bool has_table() const { return !table_.empty(); }
    // Luminance of radiance, averaged over the sphere.
    [[nodiscard]] float mean_luminance() const { return mean_luminance_; }

private:
    [[nodiscard]] float sun_pdf(const V3f& direction) const;

    const Material* world_ = nullptr;
    const SceneFrame* frame_ = nullptr;
    std::optional<Color3f> constant_ = Color3f(0.0f);  // where it is the same everywhere
    std::optional<SunDisc> sun_;
    float mean_luminance_ = 0.0f;
    DirectionTable table_;
};

}  // namespace eye_render
