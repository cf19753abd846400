// What the parts of eyecore.Scene share.

#pragma once

#include "api/scene_builder.h"
#include "module.h"

namespace eye_render {

using SceneClass = py::class_<SceneBuilder, std::shared_ptr<SceneBuilder>>;

// An output of a node, for Python.
struct NodeSocket {
    std::shared_ptr<NodeGraph> graph;
    NodeOutput output;
};

void bind_materials(SceneClass& scene);
void bind_geometry(SceneClass& scene);
void bind_instances(SceneClass& scene);
void bind_lights(SceneClass& scene);

// What is not named sees and is seen.
[[nodiscard]] Visibility visibility_from(const std::vector<std::string>& hidden_from);

// Throws std::invalid_argument if there is no such set.
[[nodiscard]] LightLinks links_from(std::uint64_t lit_classes, int blocker_set);

// Three numbers, linear; `name` is what they are for, as errors say it.
[[nodiscard]] Color3f color_from(const std::string& name, const py::handle& value);

}  // namespace eye_render
