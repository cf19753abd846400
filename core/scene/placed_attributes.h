// What a material may ask about a point of any geometry: what comes from its object, and from the
// scene. Nothing is computed before it is asked for.

#pragma once

#include "base/room.h"
#include "scene/scene_frame.h"
#include "scene/surface_hit.h"
#include "shading/hit_attributes.h"

namespace eye_render {

class PlacedAttributes : public HitAttributes {
public:
    [[nodiscard]] const ObjectFacts& object() const final;
    [[nodiscard]] const ViewFrame& view() const final { return frame_.view; }
    [[nodiscard]] Color4f texture(int texture, const V2f& uv, TextureAlpha alpha) const final
    {
        return frame_.textures->lookup(texture, uv, alpha);
    }

protected:
    // All of these outlive the attributes.
    PlacedAttributes(const Placement& placement,
                     const Pose& pose,
                     std::uint32_t primitive,
                     const SceneFrame& frame)
        : placement_(placement), pose_(pose), primitive_(primitive), frame_(frame)
    {
    }

    // What the object itself says under the attribute's name.
    [[nodiscard]] AttributeValue object_property(int attribute) const;
    [[nodiscard]] V3f in_texture_space(const V3f& p_object) const;

    const Placement& placement_;
    const Pose& pose_;
    std::uint32_t primitive_;
    const SceneFrame& frame_;

private:
    mutable Room<ObjectFacts> object_;
};

}  // namespace eye_render
