// A material: a program under a name, with what it reads of the scene.

#pragma once

#include "base/matte_id.h"
#include "shading/program.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace eye_render {

struct Material {
    std::string name;
    ShaderProgram surface;
    int pass_index = 0;
    float matte = no_matte;  // of its name
    // Numbers that the scene gave out, ascending and without repeats.
    std::vector<int> uv_layers;
    std::vector<int> attributes;
    std::vector<int> textures;
};

// Throws std::invalid_argument as ShaderProgram does.
[[nodiscard]] Material make_material(std::string name,
                                     const NodeGraph& graph,
                                     const std::optional<NodeOutput>& surface,
                                     const std::optional<NodeOutput>& displacement,
                                     NodeResources& resources);

// A material of one closure with constant inputs, the others at their defaults.
[[nodiscard]] Material plain_material(
    std::string_view closure,
    std::initializer_list<std::pair<std::string_view, NodeValue>> inputs,
    NodeOptions options = {});

}  // namespace eye_render
