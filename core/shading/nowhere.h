// A hit that is no place: it stands where one must be named for what reads nothing of it.

#pragma once

#include "shading/node.h"

namespace eye_render {

// Answers zero.
class NowhereAttributes final : public HitAttributes {
public:
    [[nodiscard]] V3f position_world() const override { return V3f(0.0f); }
    [[nodiscard]] V3f position_object() const override { return V3f(0.0f); }
    [[nodiscard]] V3f generated() const override { return V3f(0.0f); }
    [[nodiscard]] V2f uv(int /*uv_layer*/) const override { return V2f(0.0f); }
    [[nodiscard]] TangentFrame tangent(int /*uv_layer*/) const override { return {}; }
    [[nodiscard]] AttributeValue attribute(int /*attribute*/) const override { return {}; }
    [[nodiscard]] V2f parametric() const override { return V2f(0.0f); }
    [[nodiscard]] float edge_distance() const override { return 0.0f; }
    [[nodiscard]] V3f smooth_normal() const override { return {0.0f, 0.0f, 1.0f}; }
    [[nodiscard]] const ObjectFacts& object() const override { return object_; }
    [[nodiscard]] const ViewFrame& view() const override { return view_; }
    [[nodiscard]] Color4f texture(int /*texture*/,
                                  const V2f& /*uv*/,
                                  TextureAlpha /*alpha*/) const override
    {
        return Color4f(0.0f);
    }
    void moved(const V3f& /*offset*/,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(*this);
    }

private:
    ObjectFacts object_;
    ViewFrame view_;
};

class Nowhere {
public:
    [[nodiscard]] Hit hit() const
    {
        return {.point = point_, .attributes = attributes_, .path = path_};
    }

private:
    ShadingPoint point_{.wo = V3f(0.0f, 0.0f, 1.0f),
                        .ng = V3f(0.0f, 0.0f, 1.0f),
                        .ns = V3f(0.0f, 0.0f, 1.0f)};
    NowhereAttributes attributes_;
    PathState path_;
};

}  // namespace eye_render
