// A hit that answers with what a test says, and counts how often it was asked.

#pragma once

#include "shading/program.h"

#include <functional>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace eye_render::test {

// The attribute of smoothed tangents, whatever the UV layer.
inline constexpr int tangents = 9;

class MadeUpHit : public HitAttributes {
public:
    V3f p_world{0.0f};
    V3f p_object{0.0f};
    V3f p_generated{0.0f};
    V2f uv_value{0.5f};
    V2f weights{0.0f};
    Color4f texel{0.0f, 0.0f, 0.0f, 1.0f};
    std::function<Color4f(int, const V2f&)> picture;  // in place of the texel
    AttributeValue layer{.value = Color4f(0.0f, 0.0f, 0.0f, 1.0f), .exists = true};
    AttributeValue smoothed_tangent;
    TangentFrame frame{.tangent = V3f(1.0f, 0.0f, 0.0f)};
    float to_edge = 0.0f;
    V3f smooth{0.0f, 0.0f, 1.0f};
    ObjectFacts facts;
    ViewFrame camera;
    mutable int questions = 0;
    mutable TextureAlpha asked_alpha{};  // of the last texture

    [[nodiscard]] V3f position_world() const override { return answer(p_world); }
    [[nodiscard]] V3f position_object() const override { return answer(p_object); }
    [[nodiscard]] V3f generated() const override { return answer(p_generated); }
    [[nodiscard]] V2f uv(int) const override { return answer(uv_value); }
    [[nodiscard]] TangentFrame tangent(int) const override { return answer(frame); }
    [[nodiscard]] AttributeValue attribute(int number) const override
    {
        return answer(number == tangents ? smoothed_tangent : layer);
    }
    [[nodiscard]] V2f parametric() const override { return answer(weights); }
    [[nodiscard]] float edge_distance() const override { return answer(to_edge); }
    [[nodiscard]] V3f smooth_normal() const override { return answer(smooth); }
    [[nodiscard]] const ObjectFacts& object() const override { return answer(facts); }
    [[nodiscard]] const ViewFrame& view() const override { return answer(camera); }
    [[nodiscard]] Color4f texture(int texture, const V2f& uv, TextureAlpha alpha) const override
    {
        ++questions;
        asked_alpha = alpha;
        return picture ? picture(texture, uv) : texel;
    }
    // All positions move by the offset, as on an object that is neither turned nor scaled.
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        MadeUpHit there = *this;
        there.p_world += offset;
        there.p_object += offset;
        there.p_generated += offset;
        look(there);
        questions = there.questions;
    }

private:
    template <typename T>
    [[nodiscard]] const T& answer(const T& value) const
    {
        ++questions;
        return value;
    }
};

// Gives names their numbers, 0 to those it is not told of, and remembers what it was asked for.
class AnyResources final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string& name) override
    {
        uv_layers.push_back(name);
        return number_of(name);
    }
    [[nodiscard]] int attribute(const std::string& name) override
    {
        attributes.push_back(name);
        return name.ends_with(".tangent") ? tangents : number_of(name);
    }
    void require_texture(int texture) override { textures.push_back(texture); }
    [[nodiscard]] WorkingSpace working_space() override { return space; }

    std::map<std::string, int> names;
    WorkingSpace space = WorkingSpace::Rec709;
    std::vector<std::string> uv_layers;
    std::vector<std::string> attributes;
    std::vector<int> textures;

private:
    [[nodiscard]] int number_of(const std::string& name) const
    {
        const auto found = names.find(name);
        return found == names.end() ? 0 : found->second;
    }
};

// A graph that is built and compiled in one expression.
class GraphTrial {
public:
    using Options = std::map<std::string, NodeOptions::Value>;

    std::size_t add(std::string_view type, Options options = {})
    {
        return graph.add(type, NodeOptions(std::move(options)));
    }
    void link(std::size_t to, std::string_view input, std::size_t from, std::string_view output)
    {
        graph.link(to, input, graph.output(from, output));
    }
    [[nodiscard]] ShaderProgram surface(std::size_t node, std::string_view output)
    {
        return {graph, graph.output(node, output), std::nullopt, resources};
    }

    NodeGraph graph;
    AnyResources resources;
};

}  // namespace eye_render::test
