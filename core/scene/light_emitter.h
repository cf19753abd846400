// A light as the choice among lights sees it: where it is, how bright at most, and which way.
// World space; intensity is the luminance of radiant intensity, or of irradiance from infinity.

#pragma once

#include "base/vector.h"
#include "scene/lamp.h"

#include <Imath/ImathBox.h>

#include <cstdint>

namespace eye_render {

class Environment;

enum class LightKind : std::uint8_t { Lamp, Triangle, Environment };

struct EmissiveTriangle {
    V3f p0_world, p1_world, p2_world;
    float radiance = 0.0f;  // luminance, estimated, of either side
    Imath::Box3f reach{};   // around the other places of one that moves
};

[[nodiscard]] inline float triangle_area(const V3f& p0, const V3f& p1, const V3f& p2)
{
    return 0.5f * (p1 - p0).cross(p2 - p0).length();
}

struct LightEmitter {
    LightKind kind = LightKind::Lamp;
    std::uint32_t index = 0;
    V3f center_world{0.0f};
    float radius = 0.0f;         // of the sphere around all of it
    float intensity = 0.0f;      // towards the brightest direction
    bool is_distant = false;     // the environment and suns
    bool is_lambertian = false;  // falls off as the cosine from the axis
    V3f axis{0.0f};              // where the light goes; zero when it goes everywhere
    float cos_edge = -1.0f;      // nothing is emitted beyond this angle from the axis
};

[[nodiscard]] LightEmitter emitter_of(const Lamp& lamp, std::uint32_t index);
[[nodiscard]] LightEmitter emitter_of(const EmissiveTriangle& triangle, std::uint32_t index);
[[nodiscard]] LightEmitter emitter_of(const Environment& environment);

}  // namespace eye_render
