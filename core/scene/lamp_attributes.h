// What the nodes of a lamp see: a place of the lamp, looked at from the point that it lights.
//
// The normal is the lamp's surface's, or points to what is lit where the lamp has none. UVs lay a
// picture on an area lamp, the sun's disk and a spot's cone, and around a point lamp.

#pragma once

#include "scene/lamp.h"
#include "scene/scene_frame.h"

namespace eye_render {

struct LampSight {
    V3f p_lit_world{0.0f};
    V3f wi{0.0f};           // unit, to the lamp
    float distance = 0.0f;  // to the place of the lamp; infinite for the sun
};

// The lamp as nodes know it: as an object, or, as before Blender 4.4, as directions alone.
struct LampSpace {
    ObjectFacts facts;
    bool is_of_object = true;

    LampSpace(const M44d& world_from_light, bool has_own_space);
};

class LampAttributes final : public HitAttributes {
public:
    // All must outlive it.
    LampAttributes(const Lamp& lamp,
                   const LampSpace& space,
                   const LampSight& sight,
                   const SceneFrame& frame)
        : lamp_(lamp), space_(space), facts_(space.facts), sight_(sight), frame_(frame)
    {
    }

    [[nodiscard]] ShadingPoint shading_point() const;

    [[nodiscard]] V3f position_world() const override;
    [[nodiscard]] V3f position_object() const override;
    [[nodiscard]] V3f generated() const override { return position_object(); }
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
    [[nodiscard]] Color4f texture(int texture, const V2f& uv, TextureAlpha alpha) const override
    {
        return frame_.textures->lookup(texture, uv, alpha);
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
    const LampSpace& space_;
    const ObjectFacts& facts_;
    const LampSight& sight_;
    const SceneFrame& frame_;
};

}  // namespace eye_render
