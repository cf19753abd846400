// Fills a scene from outside: every call checks what it is given, so that a scene that was built
// is a scene that renders.

#pragma once

#include "render/camera.h"
#include "scene/scene_data.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eye_render {

// Values of a graph to write out for compositors.
using AovsByName = std::map<std::string, NodeOutput>;

class SceneBuilder {
public:
    // All colours that it is given, and the pictures of the scene, are in that space.
    explicit SceneBuilder(WorkingSpace space = WorkingSpace::Rec709);

    // Each of these returns the number by which the thing is referred to later, and throws
    // std::invalid_argument that names what is wrong.
    std::size_t add_geometry(Geometry geometry);
    std::size_t add_material(const std::string& name,
                             const NodeGraph& graph,
                             const MaterialOutputs& outputs,
                             int pass_index = 0,
                             const AovsByName& aovs = {});
    void add_instance(InstanceData instance);
    // The number of an attribute that some material reads, for properties of instances.
    [[nodiscard]] std::optional<int> attribute_number(const std::string& name) const;
    // Its light is multiplied by what `surface` of the graph, if it is said, shines with.
    void add_lamp(LampData lamp,
                  const NodeGraph& graph = {},
                  const std::optional<NodeOutput>& surface = std::nullopt);
    void set_world(const NodeGraph& graph,
                   const MaterialOutputs& outputs,
                   const AovsByName& aovs = {});
    // `motion`: frames of the same size at the times of scene/motion.h, or none.
    void set_camera(const CameraFrame& frame, std::vector<CameraFrame> motion = {});
    [[nodiscard]] TextureSet& textures();

    // The number of a light group; none for the empty name.
    [[nodiscard]] int light_group(const std::string& name);
    void set_world_light_group(const std::string& name);
    void set_world_visibility(const Visibility& visibility);

    // Names of the layers that the materials read.
    [[nodiscard]] std::vector<std::string> uv_layers_read(
        const std::vector<std::size_t>& materials) const;
    [[nodiscard]] std::vector<std::string> attributes_read(
        const std::vector<std::size_t>& materials) const;

    // While somebody holds a lease, every change is refused: what was built refers to the data.
    [[nodiscard]] std::shared_ptr<const void> lease() const { return lease_; }

    [[nodiscard]] const SceneData& data() const { return data_; }
    // Throws std::invalid_argument if set_camera was never called.
    [[nodiscard]] const CameraFrame& camera() const;
    [[nodiscard]] const std::vector<CameraFrame>& camera_motion() const { return camera_motion_; }
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    void require_unleased() const;
    [[nodiscard]] std::vector<AovOutput> numbered(const AovsByName& aovs);
    void warn_of_variation(const std::string& what, const ShaderProgram& volume);
    [[nodiscard]] std::vector<const Material*> materials_at(
        const std::vector<std::size_t>& numbers) const;

    std::shared_ptr<const void> lease_ = std::make_shared<int>();
    SceneData data_;
    CameraFrame camera_;
    std::vector<CameraFrame> camera_motion_;
    bool has_camera_ = false;
    std::vector<std::string> warnings_;
};

}  // namespace eye_render
