// Light of lamps and of the world that a medium scatters into a ray.

#pragma once

#include "render/sample_sequence.h"
#include "scene/scene.h"

namespace eye_render {

// A way through media that are the same all along it.
struct MediumSegment {
    V3f origin;
    V3f direction;
    float length = 0.0f;  // may be infinite
    float time = 0.0f;
    const MediumStack& media;
};

struct ScatteredLight {
    Color3f light{0.0f};
    LightOrigin origin{};
};

// One estimate of the light that is scattered once on the segment, reaches its beginning and
// counts by `throughput` there. `most_passages` is for Scene::transmittance, `point` is a place to
// weigh lights in.
[[nodiscard]] ScatteredLight sample_scattered_light(const Scene& scene,
                                                    const MediumSegment& segment,
                                                    const Color3f& throughput,
                                                    const PathState& path,
                                                    int most_passages,
                                                    LitPoint& point,
                                                    SampleSequence& sequence);

}  // namespace eye_render
