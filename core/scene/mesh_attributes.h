// What a material may ask about a point of a mesh. Nothing is computed before it is asked for.

#pragma once

#include "scene/scene_frame.h"
#include "scene/surface_hit.h"
#include "shading/hit_attributes.h"

#include <optional>

namespace eye_render {

class MeshAttributes final : public HitAttributes {
public:
    MeshAttributes(const Placement& placement,
                   std::uint32_t triangle,
                   float u,
                   float v,
                   const SceneFrame& frame)
        : placement_(placement), triangle_(triangle), u_(u), v_(v), frame_(frame)
    {
    }

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override;
    [[nodiscard]] V3f generated() const override;
    [[nodiscard]] V2f uv(int uv_layer) const override;
    [[nodiscard]] TangentFrame tangent(int uv_layer) const override;
    [[nodiscard]] AttributeValue attribute(int attribute) const override;
    [[nodiscard]] V2f parametric() const override { return {u_, v_}; }
    [[nodiscard]] float edge_distance() const override;
    [[nodiscard]] V3f smooth_normal() const override;
    [[nodiscard]] const ObjectFacts& object() const override;
    [[nodiscard]] const ViewFrame& view() const override { return frame_.view; }
    [[nodiscard]] Color4f texture(int texture, const V2f& uv, TextureAlpha alpha) const override
    {
        return frame_.textures->lookup(texture, uv, alpha);
    }
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override;

private:
    [[nodiscard]] const TriangleIndices& corner() const
    {
        return placement_.mesh->triangles[triangle_];
    }
    // The triangle's corners, in the world but relative to the eye.
    [[nodiscard]] std::array<V3f, 3> corners_world() const;

    const Placement& placement_;
    std::uint32_t triangle_;
    float u_;
    float v_;
    const SceneFrame& frame_;
    mutable std::optional<ObjectFacts> object_;
};

}  // namespace eye_render
