// Ray queries against triangles, strands and balls: a bounding-volume hierarchy built by Embree.
//
// A geometry enters either flat, given in world space, or as a prototype that is then placed any
// number of times; prototypes cost one more transformation a ray, so they are for geometry that
// occurs more than once, or that moves.

#pragma once

#include "base/vector.h"
#include "scene/curves.h"
#include "scene/mesh.h"
#include "scene/motion.h"
#include "scene/ray.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace eye_render {

struct AcceleratorHit {
    float t;
    V3f ng;   // not normalised, in the space of the geometry that was hit
    float u;  // of triangles: p = (1 - u - v) p0 + u p1 + v p2; of strands: along the segment
    float v;  // of ribbons: across, from -1 to 1
    std::uint32_t placement;  // the number that `add_flat` or `place` gave
    std::uint32_t primitive;  // triangle, segment of all strands, or ball
};

struct TriangleShape {
    std::span<const TriangleIndices> triangles;
    MotionSteps<V3f> positions;
};

struct StrandsShape {
    StrandShape kind;
    std::span<const std::uint32_t> first_keys;  // of each strand
    MotionSteps<SizedPoint> keys;
};

struct BallsShape {
    MotionSteps<SizedPoint> balls;
};

// What the accelerator copies.
using Shape = std::variant<TriangleShape, StrandsShape, BallsShape>;

class Accelerator {
public:
    Accelerator();

    // Adds a shape in world space. Returns its placement number; placements count from 0 in the
    // order of `add_flat` and `place`.
    std::uint32_t add_flat(const Shape& shape, RayMask met_by = all_rays);

    using Prototype = std::uint32_t;
    [[nodiscard]] Prototype add_prototype(const Shape& shape);
    // At one place, or at those of the times of motion.h: invertible matrices.
    std::uint32_t place(Prototype prototype,
                        std::span<const M44d> world_from_object,
                        RayMask met_by = all_rays);

    // Builds the hierarchy; call once, before the first query. Throws std::runtime_error when
    // Embree fails (out of memory, say).
    void build();

    // A ray that is not finite meets nothing and is occluded: it brings no light either way.
    // Embree itself may end the process for one.
    [[nodiscard]] std::optional<AcceleratorHit> intersect(const Ray& ray,
                                                          RayMask mask = all_rays) const;
    [[nodiscard]] bool occluded(const Ray& ray, RayMask mask = all_rays) const;

    // Vertices of a flat mesh or of a prototype, as the hierarchy holds them.
    [[nodiscard]] const MotionSteps<V3f>& positions(std::uint32_t placement) const
    {
        return positions_[shape_of_placement_[placement]];
    }

    // Where a prototype that moves is at that time: between two steps rotations turn evenly.
    [[nodiscard]] M44f world_from_object(std::uint32_t placement, float time) const;

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
    // Into `scene` as geometry number `id`; returns the number of its positions.
    std::uint32_t attach(RTCSceneTy* scene, std::uint32_t id, const Shape& shape, RayMask met_by);

    struct PlacedPrototype {
        SceneHandle scene;
        std::uint32_t shape;
    };

    std::unique_ptr<RTCDeviceTy, ReleaseDevice> device_;
    SceneHandle root_;
    std::vector<PlacedPrototype> prototypes_;
    std::vector<MotionSteps<V3f>> positions_;  // one entry a shape
    std::vector<std::uint32_t> shape_of_placement_;
};

}  // namespace eye_render
