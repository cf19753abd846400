// Ray queries against triangles: a static bounding-volume hierarchy built by Embree.
//
// A mesh enters either flat, its positions given in world space, or as a prototype that is then
// placed any number of times; prototypes cost one more transformation a ray, so they are for
// meshes that occur more than once.

#pragma once

#include "base/vector.h"
#include "scene/ray.h"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace eye_render {

using TriangleIndices = std::array<std::uint32_t, 3>;

struct AcceleratorHit {
    float t;
    V3f ng;   // not normalised, in the space of the mesh that was hit
    float u;  // p = (1 - u - v) p0 + u p1 + v p2
    float v;
    std::uint32_t placement;  // the number that `add_flat` or `place` gave
    std::uint32_t triangle;
};

class Accelerator {
public:
    Accelerator();

    // Adds a mesh in world space. Returns its placement number; placements count from 0 in the
    // order of `add_flat` and `place`.
    std::uint32_t add_flat(std::span<const V3f> positions,
                           std::span<const TriangleIndices> triangles);

    using Prototype = std::size_t;
    [[nodiscard]] Prototype add_prototype(std::span<const V3f> positions,
                                          std::span<const TriangleIndices> triangles);
    std::uint32_t place(Prototype prototype, const M44f& world_from_object);

    // Builds the hierarchy; call once, before the first query. Throws std::runtime_error when
    // Embree fails (out of memory, say).
    void build();

    // A ray that is not finite meets nothing and is occluded: it brings no light either way.
    // Embree itself may end the process for one.
    [[nodiscard]] std::optional<AcceleratorHit> intersect(const Ray& ray) const;
    [[nodiscard]] bool occluded(const Ray& ray) const;

    // Positions of a flat mesh or a prototype, as the hierarchy holds them.
    [[nodiscard]] std::span<const V3f> positions(std::uint32_t placement) const
    {
        return placement_positions_[placement];
    }

private:
    struct ReleaseDevice {
        void operator()(RTCDeviceTy* device) const;
    };
    struct ReleaseScene {
        void operator()(RTCSceneTy* scene) const;
    };
    using SceneHandle = std::unique_ptr<RTCSceneTy, ReleaseScene>;

    [[nodiscard]] SceneHandle new_scene() const;
    void check_device() const;

    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
    SceneHandle root_;
    std::vector<SceneHandle> prototypes_;
    std::vector<std::span<const V3f>> prototype_positions_;
    std::vector<std::span<const V3f>> placement_positions_;
};

}  // namespace eye_render
