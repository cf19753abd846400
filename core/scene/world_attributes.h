// What the world's material may ask: everything is the direction that is looked along.

#pragma once

#include "scene/scene_frame.h"

namespace eye_render {

class WorldAttributes final : public HitAttributes {
public:
    WorldAttributes(const V3f& direction, const SceneFrame& frame)
        : direction_(direction), frame_(frame)
    {
    }

    [[nodiscard]] V3f position_world() const override { return direction_; }
    [[nodiscard]] V3f position_object() const override { return direction_; }
    [[nodiscard]] V3f generated() const override { return direction_; }
    [[nodiscard]] V2f uv(int /*uv_layer*/) const override { return V2f(0.0f); }
    [[nodiscard]] TangentFrame tangent(int /*uv_layer*/) const override { return {}; }
    [[nodiscard]] AttributeValue attribute(int /*attribute*/) const override { return {}; }
    [[nodiscard]] V2f parametric() const override { return V2f(0.0f); }
    [[nodiscard]] float edge_distance() const override { return 0.0f; }
    [[nodiscard]] V3f smooth_normal() const override { return -direction_; }
    [[nodiscard]] const ObjectFacts& object() const override
    {
        static const ObjectFacts nothing{
            .world_from_object = {}, .object_from_world = {}, .color = Color4f(0.0f)};
        return nothing;
    }
    [[nodiscard]] const ViewFrame& view() const override { return frame_.direction_view; }
    [[nodiscard]] Color4f texture(int texture, const V2f& uv, TextureAlpha alpha) const override
    {
        return frame_.textures->lookup(texture, uv, alpha);
    }
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(WorldAttributes(unit_or(direction_ + offset, direction_), frame_));
    }

private:
    V3f direction_;
    const SceneFrame& frame_;
};

}  // namespace eye_render
