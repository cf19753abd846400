// What the nodes of a lamp see: a place of the lamp, looked at from the point that it lights.
//
// As in Cycles, positions are those of the world also where nodes ask for the object's own or for
// generated ones; directions are the lamp's own. The normal is the lamp's surface's, or points to
// what is lit where the lamp has none. UVs lay a picture on an area lamp, the sun's disk and a
// spot's cone, and around a point lamp.

#pragma once

#include "scene/lamp.h"
#include "scene/scene_frame.h"

namespace eye_render {

struct LampSight {
    V3f p_lit_world{0.0f};
    V3f wi{0.0f};           // unit, to the lamp
    float distance = 0.0f;  // to the place of the lamp; infinite for the sun
};

class LampAttributes final : public HitAttributes {
public:
    // All must outlive it. `facts` are of the lamp's object.
    LampAttributes(const Lamp& lamp,
                   const ObjectFacts& facts,
                   const LampSight& sight,
                   const SceneFrame& frame)
        : lamp_(lamp), facts_(facts), sight_(sight), frame_(frame)
    {
    }

    [[nodiscard]] ShadingPoint shading_point() const;

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override { return position_world(); }
    [[nodiscard]] V3f generated() const override { return position_world(); }
    // Nothing but the active layer is there.
    [[nodiscard]] V2f uv(int uv_layer) const override;
    [[nodiscard]] TangentFrame tangent(int /*uv_layer*/) const override { return {}; }
    [[nodiscard]] AttributeValue attribute(int /*attribute*/) const override { return {}; }
    // So that the Geometry node's Parametric is the UV.
    [[nodiscard]] V2f parametric() const override;
    [[nodiscard]] float edge_distance() const override { return 0.0f; }
    [[nodiscard]] V3f smooth_normal() const override;
    [[nodiscard]] const ObjectFacts& object() const override { return facts_; }
    [[nodiscard]] const ViewFrame& view() const override { return frame_.view; }
    [[nodiscard]] Color4f texture(int texture, const V2f& uv) const override
    {
        return frame_.textures->lookup(texture, uv);
    }
    // A lamp has no bumps.
    void moved(const V3f& /*offset*/,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(*this);
    }

private:
    // From the lamp's position.
    [[nodiscard]] V3f to_place() const
    {
        return sight_.p_lit_world + sight_.wi * sight_.distance - lamp_.position;
    }
    [[nodiscard]] V2f uv_of_point() const;
    [[nodiscard]] V2f uv_of_spot() const;
    [[nodiscard]] V2f uv_of_area() const;
    [[nodiscard]] V2f uv_of_sun() const;

    const Lamp& lamp_;
    const ObjectFacts& facts_;
    const LampSight& sight_;
    const SceneFrame& frame_;
};

}  // namespace eye_render
