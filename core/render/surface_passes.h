// What the surfaces that the camera sees tell of themselves, whatever light falls on them.

#pragma once

#include "render/pass_values.h"
#include "render/sample_sequence.h"
#include "scene/scene.h"

#include <array>
#include <string_view>

namespace eye_render {

// How the mist thickens from where it begins to where it is full.
enum class MistFalloff { Quadratic, Linear, InverseQuadratic };

inline constexpr std::array mist_falloffs{MistFalloff::Quadratic, MistFalloff::Linear,
                                          MistFalloff::InverseQuadratic};

// "QUADRATIC", "LINEAR", "INVERSE_QUADRATIC".
[[nodiscard]] std::string_view to_string(MistFalloff falloff);

struct SurfacePassSettings {
    // Distances from the eye, scene units.
    float mist_start = 5.0f;
    float mist_depth = 25.0f;
    MistFalloff mist_falloff = MistFalloff::Quadratic;
    // What is farther covers nothing of a surface's sky.
    float occlusion_distance = 10.0f;
};

// 0 to 1.
[[nodiscard]] float mist_at(float distance, const SurfacePassSettings& settings);

// A surface along the camera's ray.
struct SeenSurface {
    const Scene& scene;
    const SurfaceHit& hit;
    const ShadedPoint& shaded;
    const PathState& path;
    Color3f throughput;  // what those before it let pass
};

// What one path tells of the surfaces it meets.
class SurfacePasses {
public:
    // Without `values` nothing is wanted.
    SurfacePasses(PassValues* values, const SurfacePassSettings& settings);

    // Of the next surface. `sequence` is for this alone.
    void note(const SeenSurface& seen, SampleSequence sequence)
    {
        if (seeks_features_) {
            note_features(seen);
        }
        if (values_ != nullptr && seen.path.depth == 0) {
            note_seen(seen, sequence);
        }
    }

    // Of the world, which the path sees where there are no more surfaces.
    void note_world(const Scene& scene,
                    const V3f& direction,
                    const PathState& path,
                    const Color3f& throughput);

private:
    // What the camera sees, by how much of it: what it lets pass straight is left to what is
    // behind.
    void note_seen(const SeenSurface& seen, SampleSequence sequence);
    // What helps a denoiser: of the first surface along the path that is rough enough to have a
    // look of its own, in the colour of the mirrors and glasses before it.
    void note_features(const SeenSurface& seen);

    PassValues* values_;
    const SurfacePassSettings& settings_;
    Color3f feature_throughput_{1.0f};
    bool seeks_features_;
};

}  // namespace eye_render
