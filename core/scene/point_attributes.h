// What a material may ask about a point on a ball of a point cloud.

#pragma once

#include "scene/placed_attributes.h"

namespace eye_render {

class PointAttributes final : public PlacedAttributes {
public:
    // `hit` on a placement of points. `p_world` is relative to the eye.
    PointAttributes(const SurfaceHit& hit,
                    const V3f& p_world,
                    const Pose& pose,
                    const SceneFrame& frame)
        : PlacedAttributes(*hit.placement, pose, hit.primitive, frame), hit_(hit),
          p_world_(p_world), points_(std::get<Points>(*hit.placement->geometry))
    {
    }

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override;
    // Of the ball's centre.
    [[nodiscard]] V3f generated() const override;
    [[nodiscard]] V2f uv(int /*uv_layer*/) const override { return V2f(0.0f); }
    [[nodiscard]] TangentFrame tangent(int /*uv_layer*/) const override { return {}; }
    [[nodiscard]] AttributeValue attribute(int attribute) const override;
    [[nodiscard]] V2f parametric() const override { return V2f(0.0f); }
    // A ball has none: as far away as can be.
    [[nodiscard]] float edge_distance() const override;
    [[nodiscard]] V3f smooth_normal() const override { return hit_.point.ns; }
    [[nodiscard]] std::optional<PointFacts> point() const override;
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(PointAttributes(hit_, p_world_ + offset, pose_, frame_));
    }

private:
    const SurfaceHit& hit_;
    V3f p_world_;
    const Points& points_;
};

}  // namespace eye_render
