// What a material may ask about a point of a mesh. Nothing is computed before it is asked for.

#pragma once

#include "scene/placed_attributes.h"

#include <array>

namespace eye_render {

class MeshAttributes final : public PlacedAttributes {
public:
    // Of a mesh's placement.
    MeshAttributes(const Placement& placement,
                   const Pose& pose,
                   std::uint32_t triangle,
                   float u,
                   float v,
                   float time,
                   const SceneFrame& frame)
        : PlacedAttributes(placement, pose, triangle, frame), mesh_(*placement.mesh()), u_(u),
          v_(v), time_(time)
    {
    }

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override;
    [[nodiscard]] V3f generated() const override { return in_texture_space(position_object()); }
    [[nodiscard]] V2f uv(int uv_layer) const override;
    [[nodiscard]] TangentFrame tangent(int uv_layer) const override;
    [[nodiscard]] AttributeValue attribute(int attribute) const override;
    [[nodiscard]] V2f parametric() const override { return {u_, v_}; }
    [[nodiscard]] float edge_distance() const override;
    [[nodiscard]] V3f smooth_normal() const override;
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override;

private:
    // The triangle's corners, in the world but relative to the eye.
    [[nodiscard]] std::array<V3f, 3> corners_world() const;

    const Mesh& mesh_;
    float u_;
    float v_;
    float time_;
};

}  // namespace eye_render
