// Materials from graphs of nodes, for tests of the renderer.

#pragma once

#include "../shading/options_of.h"
#include "scene/scene_data.h"

#include <algorithm>

namespace eye_render::test {

// Gives names their numbers in the scene.
class SceneNames final : public NodeResources {
public:
    explicit SceneNames(SceneData& data) : data_(data) {}

    [[nodiscard]] int uv_layer(const std::string& name) override
    {
        return number_of(name, data_.uv_layer_names);
    }
    [[nodiscard]] int attribute(const std::string& name) override
    {
        return number_of(name, data_.attribute_names);
    }
    void require_texture(int) override {}
    [[nodiscard]] WorkingSpace working_space() override { return data_.working_space; }

private:
    [[nodiscard]] static int number_of(const std::string& name, std::vector<std::string>& names)
    {
        const auto found = std::ranges::find(names, name);
        const auto number = static_cast<int>(found - names.begin());
        if (found == names.end()) {
            names.push_back(name);
        }
        return number;
    }

    SceneData& data_;
};

// What `surface` of the graph makes.
[[nodiscard]] inline Material made(SceneData& data,
                                   const NodeGraph& graph,
                                   const NodeOutput& surface)
{
    SceneNames names(data);
    return make_material("m", graph, {.surface = surface}, names);
}

inline int add_grey_picture(SceneData& data)
{
    const std::vector<float> pixels(16, 0.5f);
    return data.textures.add_pixels("grey", PixelsF32{.width = 2, .height = 2, .rgba = pixels},
                                    {});
}

// A diffuse surface of texture 0, laid out by that UV layer.
[[nodiscard]] inline Material pictured(SceneData& data, const std::string& uv_layer)
{
    NodeGraph graph;
    const std::size_t map = graph.add("UVMAP", test::options_of({{"uv_map", uv_layer}}));
    const std::size_t image = graph.add("TEX_IMAGE", test::options_of({{"texture", 0.0}}));
    const std::size_t diffuse = graph.add("BSDF_DIFFUSE");
    graph.link(image, "Vector", graph.output(map, "UV"));
    graph.link(diffuse, "Color", graph.output(image, "Color"));
    return made(data, graph, graph.output(diffuse, "BSDF"));
}

// Texture 0 all around.
[[nodiscard]] inline Material pictured_world(SceneData& data)
{
    NodeGraph graph;
    const std::size_t picture = graph.add("TEX_ENVIRONMENT", test::options_of({{"texture", 0.0}}));
    const std::size_t background = graph.add("BACKGROUND");
    graph.link(background, "Color", graph.output(picture, "Color"));
    return made(data, graph, graph.output(background, "Background"));
}

}  // namespace eye_render::test
