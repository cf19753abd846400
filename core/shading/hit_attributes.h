// What a material can ask of the place it is evaluated at. A mesh, the world and a lamp answer
// each in their way (scene/). World space here is Blender's, not relative to the eye.

#pragma once

#include "base/vector.h"

#include <cstdint>
#include <functional>
#include <optional>

namespace eye_render {

struct TangentFrame {
    V3f tangent{0.0f};  // d(position)/du, normalised, world space; zero if the map is degenerate
    float bitangent_sign = 1.0f;  // B = sign * cross(N, T)
};

// How the colour of a picture with alpha is wanted. Associated, it is dimmed by alpha before its
// encoding is undone, as Cycles shows it where nobody asks for the alpha.
enum class TextureAlpha : std::uint8_t { Straight, Associated };

// A layer or property that a node reads by name. Colours are linear, straight alpha.
struct AttributeValue {
    Color4f value{0.0f};
    bool exists = false;
};

// The object that was hit, as the Object Info node tells it. Row-vector convention.
struct ObjectFacts {
    M44f world_from_object;
    M44f object_from_world;
    Color4f color{1.0f};
    float pass_index = 0.0f;
    float material_index = 0.0f;
    float random = 0.0f;  // of this instance, in [0, 1)
};

// The observer, as coordinates Camera and Window and the Camera Data node want it.
struct ViewFrame {
    M44f camera_from_world;  // +X right, +Y up, -Z ahead
    // window = (slope - first) / (last - first), slope being x / -z and y / -z.
    V2f slope_first{-1.0f};
    V2f slope_last{1.0f};
};

// A strand where it was hit. Lengths in object space.
struct StrandFacts {
    float intercept = 0.0f;  // from root, 0, to tip, 1
    float length = 0.0f;
    float thickness = 0.0f;  // diameter
    float random = 0.0f;     // of this strand, in [0, 1]
    V3f tangent{0.0f};       // as HitAttributes::tangent
};

// A ball of a point cloud.
struct PointFacts {
    V3f position_world{0.0f};
    float radius = 0.0f;
    float random = 0.0f;  // of this point, in [0, 1]
};

class HitAttributes {
public:
    static constexpr int active_uv_layer = 0;  // whatever the mesh calls it

    virtual ~HitAttributes() = default;

    [[nodiscard]] virtual V3f position_world() const = 0;
    [[nodiscard]] virtual V3f position_object() const = 0;
    // Blender's texture space: 0 to 1 over the bounding box of the undeformed mesh.
    [[nodiscard]] virtual V3f generated() const = 0;
    [[nodiscard]] virtual V2f uv(int uv_layer) const = 0;
    [[nodiscard]] virtual TangentFrame tangent(int uv_layer) const = 0;
    [[nodiscard]] virtual AttributeValue attribute(int attribute) const = 0;
    // Position within the primitive: barycentric coordinates of a triangle.
    [[nodiscard]] virtual V2f parametric() const = 0;
    // Distance to the nearest edge of the triangle, world units.
    [[nodiscard]] virtual float edge_distance() const = 0;
    // Smoothed normal without any map, unit, world, on the mesh's own side.
    [[nodiscard]] virtual V3f smooth_normal() const = 0;
    [[nodiscard]] virtual const ObjectFacts& object() const = 0;
    // Nothing on what is no strand, or no point.
    [[nodiscard]] virtual std::optional<StrandFacts> strand() const { return std::nullopt; }
    [[nodiscard]] virtual std::optional<PointFacts> point() const { return std::nullopt; }
    [[nodiscard]] virtual const ViewFrame& view() const = 0;

    // In the working space.
    [[nodiscard]] virtual Color4f texture(int texture,
                                          const V2f& uv,
                                          TextureAlpha alpha) const = 0;

    // Calls `look` with what this would be `offset` (world) further along the surface, taken as
    // flat: for bump mapping.
    virtual void moved(const V3f& offset,
                       const std::function<void(const HitAttributes&)>& look) const = 0;
};

}  // namespace eye_render
