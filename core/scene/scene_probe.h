// The rays that nodes send from a hit, answered by the scene.

#pragma once

#include "scene/surface_hit.h"
#include "shading/surface_probe.h"

#include <optional>

namespace eye_render {

class Scene;

// The nearest surface of one object, but for a primitive that the ray starts on.
[[nodiscard]] std::optional<SurfaceHit> intersect_object(const Scene& scene,
                                                         const Ray& ray,
                                                         const Placement& object,
                                                         std::optional<std::uint32_t> but = {});

class SceneProbe final : public SurfaceProbe {
public:
    // Both must outlive the probe.
    SceneProbe(const Scene& scene, const SurfaceHit& hit) : scene_(scene), hit_(hit) {}

    [[nodiscard]] bool is_blocked(const V3f& direction, float distance, bool local) const override;
    void cross_own_object(const V3f& start,
                          const V3f& direction,
                          float length,
                          const std::function<void(const Crossing&)>& visit) const override;
    [[nodiscard]] std::uint64_t seed() const override;

private:
    const Scene& scene_;
    const SurfaceHit& hit_;
};

}  // namespace eye_render
