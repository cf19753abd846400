// A path's way through media: they take from its light, and may send it elsewhere.

#pragma once

#include "render/medium_light.h"

namespace eye_render {

struct Collision {
    V3f p_world;
    V3f direction;     // that the path goes on in
    float pdf = 0.0f;  // of that direction, per unit solid angle
};

struct MediumFlight {
    Color3f weight;  // of what is behind the segment, or of light from the collision's direction
    std::optional<Collision> collision;
};

// Draws whether the path, which has some throughput left, is scattered on the segment.
[[nodiscard]] MediumFlight sample_flight(const MediumSegment& segment,
                                         const Color3f& throughput,
                                         SampleSequence& sequence);

}  // namespace eye_render
