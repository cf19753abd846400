// A scene as plain data, before anything is built from it. World positions are double and
// absolute; what is built (scene.h) is float and relative to the eye.

#pragma once

#include "scene/environment.h"
#include "scene/lamp.h"
#include "scene/mesh.h"
#include "scene/textures.h"
#include "shading/material.h"

#include <array>
#include <string>
#include <vector>

namespace eye_render {

struct InstanceData {
    std::size_t mesh = 0;
    M44d world_from_object;              // row-vector convention
    std::vector<std::size_t> materials;  // one a slot of the mesh; empty: the plain material
};

struct LampData {
    std::string name;
    LampSettings settings;  // world_from_light is left out of account
    M44d world_from_light;
};

struct SceneData {
    std::vector<Mesh> meshes;
    std::vector<InstanceData> instances;
    std::vector<Material> materials;
    std::vector<LampData> lamps;
    EnvironmentSettings world;
    TextureSet textures;
    // Names behind the layer numbers of MaterialInput. The empty name asks for a mesh's first
    // layer.
    std::vector<std::string> uv_layer_names;
    std::vector<std::string> color_attribute_names;
};

// Every input of a material, whether its surface uses it or not.
[[nodiscard]] std::array<const MaterialInput*, 11> inputs_of(const Material& material);

// The layer numbers that some input of the materials reads, ascending and without repeats.
[[nodiscard]] std::vector<int> uv_layers_read(const std::vector<const Material*>& materials);
[[nodiscard]] std::vector<int> color_attributes_read(
    const std::vector<const Material*>& materials);

}  // namespace eye_render
