// What is left out of the paths of light, for time and against noise. Without any of it the
// picture is the scene's own; each of these takes light away, or moves it.

#pragma once

#include "scene/scene.h"

namespace eye_render {

// As many bounces as can be asked for.
inline constexpr int most_bounces = 1024;

struct LightPathLimits {
    // Bounces of a kind among all: by reflection on wide lobes, on glossy ones, of both kinds
    // through a surface, and in media. The ray after the last one still finds what shines by
    // itself.
    int diffuse_bounces = most_bounces;
    int glossy_bounces = most_bounces;
    int transmission_bounces = most_bounces;
    int volume_bounces = most_bounces;
    // Surfaces that a shadow ray passes straight through; a path passes one more.
    int transparent_bounces = max_straight_passages;
    // Glossy reflection and refraction of what lights diffuse surfaces.
    bool reflective_caustics = true;
    bool refractive_caustics = true;
    // Roughens what a path meets after a bounce with a density (per unit solid angle) below this,
    // to an alpha of 1/2 where it is far below.
    float filter_glossy = 0.0f;
    // The most that one contribution to a sample may bring, as the mean of its channels: of light
    // that was scattered once at most, and of the rest. 0: as much as it likes.
    float clamp_direct = 0.0f;
    float clamp_indirect = 0.0f;
};

// Throws std::invalid_argument for a number out of range.
void require_valid(const LightPathLimits& limits);

}  // namespace eye_render
