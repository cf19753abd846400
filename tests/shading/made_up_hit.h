// A hit that answers with what a test says, and counts how often it was asked.

#pragma once

#include "shading/material.h"

namespace eye_render::test {

class MadeUpHit : public HitAttributes {
public:
    Color4f texel{0.0f, 0.0f, 0.0f, 1.0f};
    Color4f vertex_color{0.0f, 0.0f, 0.0f, 1.0f};
    TangentFrame frame{.tangent = V3f(1.0f, 0.0f, 0.0f)};
    mutable int questions = 0;

    [[nodiscard]] V2f uv(int) const override { return answer(V2f(0.5f)); }
    [[nodiscard]] TangentFrame tangent(int) const override { return answer(frame); }
    [[nodiscard]] Color4f color(int) const override { return answer(vertex_color); }
    [[nodiscard]] Color4f texture(int, const V2f&) const override { return answer(texel); }

private:
    template <typename T>
    [[nodiscard]] T answer(const T& value) const
    {
        ++questions;
        return value;
    }
};

[[nodiscard]] inline MaterialInput constant(const Color3f& value) { return {.constant = value}; }
[[nodiscard]] inline MaterialInput constant(float value) { return {.constant = Color3f(value)}; }
[[nodiscard]] inline MaterialInput from_texture(Channel channel = Channel::Color)
{
    return {.texture = 0, .uv_layer = 0, .channel = channel};
}

}  // namespace eye_render::test
