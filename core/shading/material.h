// A material: a program under a name, with what it reads of the scene.

#pragma once

#include "base/matte_id.h"
#include "shading/program.h"

#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace eye_render {

// A value that a material writes out, under the scene's number for its name.
struct MaterialAov {
    int number = 0;
    ShaderProgram program;
};

struct Material {
    std::string name;
    ShaderProgram surface;
    ShaderProgram volume;      // what fills the inside; without leaves for nothing
    bool is_boundary = false;  // of the volume: there is no surface
    int pass_index = 0;
    float matte = no_matte;  // of its name
    // Numbers that the scene gave out, ascending and without repeats.
    std::vector<int> uv_layers;
    std::vector<int> attributes;
    std::vector<int> textures;
    std::vector<MaterialAov> aovs;

    // Nothing if the material writes out no such value.
    [[nodiscard]] const ShaderProgram* aov(int number) const;
    [[nodiscard]] bool has_volume() const { return volume.leaf_count() > 0; }
};

struct AovOutput {
    int number = 0;
    NodeOutput output;
};

// What is linked to a material's or a world's output: nothing is black, but light passes straight
// through a surface of nothing around a volume. The displacement is shown as bump.
struct MaterialOutputs {
    std::optional<NodeOutput> surface{};
    std::optional<NodeOutput> displacement{};
    std::optional<NodeOutput> volume{};
};

// Throws std::invalid_argument as ShaderProgram does.
[[nodiscard]] Material make_material(std::string name,
                                     const NodeGraph& graph,
                                     const MaterialOutputs& outputs,
                                     NodeResources& resources,
                                     const std::vector<AovOutput>& aovs = {});

// A material of one closure with constant inputs, the others at their defaults.
[[nodiscard]] Material plain_material(
    std::string_view closure,
    std::initializer_list<std::pair<std::string_view, NodeValue>> inputs,
    NodeOptions options = {});

}  // namespace eye_render
