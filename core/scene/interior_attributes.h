// What the material of a volume may ask about a point within a mesh: where it is, and which object
// it is in. What only a surface has is zero.

#pragma once

#include "scene/placed_attributes.h"

namespace eye_render {

class InteriorAttributes final : public PlacedAttributes {
public:
    // `triangle` is one with the material.
    InteriorAttributes(const Placement& placement,
                       std::uint32_t triangle,
                       const V3f& p_object,
                       const SceneFrame& frame)
        : PlacedAttributes(placement, placement.pose, triangle, frame), p_object_(p_object)
    {
    }

    [[nodiscard]] V3f position_world() const override
    {
        return {V3d(p_object_ * pose_.world_from_object) + frame_.eye_position_world};
    }
    [[nodiscard]] V3f position_object() const override { return p_object_; }
    [[nodiscard]] V3f generated() const override { return in_texture_space(p_object_); }
    [[nodiscard]] V2f uv(int /*uv_layer*/) const override { return V2f(0.0f); }
    [[nodiscard]] TangentFrame tangent(int /*uv_layer*/) const override { return {}; }
    [[nodiscard]] AttributeValue attribute(int attribute) const override
    {
        return object_property(attribute);
    }
    [[nodiscard]] V2f parametric() const override { return V2f(0.0f); }
    [[nodiscard]] float edge_distance() const override { return 0.0f; }
    [[nodiscard]] V3f smooth_normal() const override { return {0.0f, 0.0f, 1.0f}; }
    void moved(const V3f& /*offset*/,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(*this);
    }

private:
    V3f p_object_;
};

}  // namespace eye_render
