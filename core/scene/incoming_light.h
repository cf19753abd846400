// Light on its way to a point that is shaded.

#pragma once

#include "base/vector.h"
#include "scene/light_links.h"
#include "scene/light_origin.h"
#include "scene/visibility.h"

#include <cstdint>

namespace eye_render {

// Light that arrives at a point, before anything stands in its way.
struct IncomingLight {
    V3f wi;
    float distance = 0.0f;  // infinite for the environment and the sun
    Color3f radiance;
    float pdf = 0.0f;  // per unit solid angle, the choice of the light included
    // Whether a ray that a BSDF sends this way may find the light too, so that MIS must weigh.
    bool is_met_by_rays = true;
    bool casts_shadow = true;
    Visibility visibility{};    // for which kinds of scattering it is there
    bool is_surface = false;    // of an object: a thing that is seen, not a lamp or the world
    bool is_of_catcher = true;  // there, too, where only shadow catchers are: all but objects
    LightLinks links{};
    LightOrigin origin{};
    float lamp_probability = 0.0f;  // of choosing this lamp among all lights; 0: not a lamp
};

// Lamps that a ray meets, to be weighed against sampling them.
struct LampContribution {
    float t = 0.0f;  // from the point
    Color3f radiance;
    float pdf = 0.0f;        // of sampling this direction once the lamp is chosen
    std::uint32_t lamp = 0;  // its number
    LightLinks links;
    LightOrigin origin;
};

// Shadow rays stop this much short of a lamp or emitter, relative to its distance: 32 float steps,
// 0.1 mm at 30 m, for the roundings of distance and direction.
inline constexpr float shadow_margin = 4e-6f;

}  // namespace eye_render
