// What a material may ask about a point of a strand.

#pragma once

#include "scene/placed_attributes.h"

namespace eye_render {

class CurveAttributes final : public PlacedAttributes {
public:
    // `hit` on a placement of curves. `p_world` is relative to the eye.
    CurveAttributes(const SurfaceHit& hit,
                    const V3f& p_world,
                    const Pose& pose,
                    const SceneFrame& frame)
        : PlacedAttributes(*hit.placement, pose, hit.primitive, frame), hit_(hit),
          p_world_(p_world), curves_(std::get<Curves>(*hit.placement->geometry)),
          place_(strand_place(curves_, hit.primitive, hit.u))
    {
    }

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override;
    // Where the strand's root is.
    [[nodiscard]] V3f generated() const override;
    // Of all of the strand.
    [[nodiscard]] V2f uv(int uv_layer) const override;
    // Along the strand: from root to tip, but seen from inside the other way.
    [[nodiscard]] TangentFrame tangent(int uv_layer) const override;
    [[nodiscard]] AttributeValue attribute(int attribute) const override;
    // Along the segment alone.
    [[nodiscard]] V2f parametric() const override { return {hit_.u, 0.0f}; }
    // A strand has none: as far away as can be.
    [[nodiscard]] float edge_distance() const override;
    [[nodiscard]] V3f smooth_normal() const override { return hit_.point.ns; }
    [[nodiscard]] std::optional<StrandFacts> strand() const override;
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(CurveAttributes(hit_, p_world_ + offset, pose_, frame_));
    }

private:
    const SurfaceHit& hit_;
    V3f p_world_;
    const Curves& curves_;
    StrandPlace place_;
};

}  // namespace eye_render
