#include "api/scene_builder.h"

#include "api/scene_checks.h"
#include "api/scene_resources.h"
#include "base/error.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace eye_render {

namespace {

std::string said_name(const Geometry& geometry)
{
    constexpr std::array<const char*, 3> kinds{"mesh", "curves", "points"};
    return std::string(kinds.at(geometry.index())) + " '" + name_of(geometry) + "'";
}

std::vector<std::string> pick(const std::vector<std::string>& names,
                              const std::vector<int>& layers)
{
    std::vector<std::string> picked;
    picked.reserve(layers.size());
    for (const int layer : layers) {
        picked.push_back(names[static_cast<std::size_t>(layer)]);
    }
    return picked;
}

}  // namespace

SceneBuilder::SceneBuilder(WorkingSpace space)
{
    data_.working_space = space;
    data_.textures = TextureSet(space);
}

void SceneBuilder::require_unleased() const
{
    if (lease_.use_count() > 1) {
        throw std::invalid_argument(
            "the scene cannot change while a session of it exists; let go of the session, or make "
            "another scene");
    }
}

TextureSet& SceneBuilder::textures()
{
    require_unleased();
    return data_.textures;
}

std::size_t SceneBuilder::add_geometry(Geometry geometry)
{
    require_unleased();
    validate(geometry);
    const std::string dropped = drop_broken(geometry);
    if (!dropped.empty()) {
        warnings_.push_back(said_name(geometry) + ": " + dropped + " are left out");
    }
    data_.geometries.push_back(std::move(geometry));
    return data_.geometries.size() - 1;
}

std::size_t SceneBuilder::add_material(const std::string& name,
                                       const NodeGraph& graph,
                                       const MaterialOutputs& outputs,
                                       int pass_index,
                                       const AovsByName& aovs)
{
    require_unleased();
    SceneResources resources(data_);
    Material material = make_material(name, graph, outputs, resources, numbered(aovs));
    material.pass_index = pass_index;
    warn_of_variation("material '" + name + "'", material.volume);
    data_.materials.push_back(std::move(material));
    return data_.materials.size() - 1;
}

void SceneBuilder::warn_of_variation(const std::string& what, const ShaderProgram& volume)
{
    if (volume.varies_in_space()) {
        warnings_.push_back(what + ": the volume varies in space, which is not supported; its "
                                   "mean is shown");
    }
}

void SceneBuilder::add_instance(InstanceData instance)
{
    require_unleased();
    require_index("geometry", instance.geometry, data_.geometries.size());
    const std::string name = said_name(data_.geometries[instance.geometry]);
    require_finite("world_from_object of " + name, instance.world_from_object);
    require_valid(instance.links);
    require_valid(instance.linked);
    require_steps("motion of " + name, instance.motion.size());
    require_range("terminator_cosine of " + name, static_cast<double>(instance.terminator_cosine),
                  0.0, 1.0, "");
    for (const M44d& place : instance.motion) {
        require_finite("motion of " + name, place);
    }
    for (const std::size_t material : instance.materials) {
        require_index("material", material, data_.materials.size());
    }
    data_.instances.push_back(std::move(instance));
}

std::optional<int> SceneBuilder::attribute_number(const std::string& name) const
{
    const auto found = std::ranges::find(data_.attribute_names, name);
    if (found == data_.attribute_names.end()) {
        return std::nullopt;
    }
    return static_cast<int>(found - data_.attribute_names.begin());
}

void SceneBuilder::add_lamp(LampData lamp,
                            const NodeGraph& graph,
                            const std::optional<NodeOutput>& surface)
{
    require_unleased();
    if (surface) {
        SceneResources resources(data_);
        Material nodes = make_material(lamp.name, graph, {.surface = surface}, resources);
        if (const auto constant = nodes.surface.constant_emission()) {
            lamp.settings.color *= *constant;
            for (LampPose& pose : lamp.motion) {
                pose.settings.color *= *constant;
            }
        } else {
            lamp.nodes = std::move(nodes);
        }
    }
    try {
        require_valid(lamp.links);
        require_valid(LampPose{lamp.settings, lamp.world_from_light});
        require_steps("the motion", lamp.motion.size());
        for (const LampPose& pose : lamp.motion) {
            require_valid(pose);
        }
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("lamp '" + lamp.name + "': " + error.what());
    }
    data_.lamps.push_back(std::move(lamp));
}

void SceneBuilder::set_world(const NodeGraph& graph,
                             const MaterialOutputs& outputs,
                             const AovsByName& aovs)
{
    require_unleased();
    SceneResources resources(data_);
    data_.world = make_material("world", graph, outputs, resources, numbered(aovs));
    warn_of_variation("world", data_.world.volume);
    data_.world_sun =
        outputs.surface ? sun_shown(graph, *outputs.surface, data_.working_space) : std::nullopt;
}

std::vector<AovOutput> SceneBuilder::numbered(const AovsByName& aovs)
{
    std::vector<AovOutput> outputs;
    for (const auto& [name, output] : aovs) {
        outputs.push_back({.number = intern(data_.aovs, name), .output = output});
    }
    return outputs;
}

int SceneBuilder::light_group(const std::string& name)
{
    require_unleased();
    return name.empty() ? no_light_group : intern(data_.light_groups, name);
}

void SceneBuilder::set_world_light_group(const std::string& name)
{
    data_.world_light_group = light_group(name);
}

void SceneBuilder::set_world_visibility(const Visibility& visibility)
{
    require_unleased();
    data_.world_visibility = visibility;
}

void SceneBuilder::set_camera(const CameraFrame& frame, std::vector<CameraFrame> motion)
{
    require_unleased();
    validate(frame);
    require_steps("the camera's motion", motion.size());
    for (const CameraFrame& pose : motion) {
        validate(pose);
    }
    camera_ = frame;
    camera_motion_ = std::move(motion);
    has_camera_ = true;
}

std::vector<const Material*> SceneBuilder::materials_at(
    const std::vector<std::size_t>& numbers) const
{
    std::vector<const Material*> materials;
    for (const std::size_t number : numbers) {
        require_index("material", number, data_.materials.size());
        materials.push_back(&data_.materials[number]);
    }
    return materials;
}

std::vector<std::string> SceneBuilder::uv_layers_read(
    const std::vector<std::size_t>& materials) const
{
    return pick(data_.uv_layer_names, eye_render::uv_layers_read(materials_at(materials)));
}

std::vector<std::string> SceneBuilder::attributes_read(
    const std::vector<std::size_t>& materials) const
{
    return pick(data_.attribute_names, eye_render::attributes_read(materials_at(materials)));
}

const CameraFrame& SceneBuilder::camera() const
{
    if (!has_camera_) {
        throw std::invalid_argument("the scene has no camera");
    }
    return camera_;
}

std::vector<std::string> SceneBuilder::warnings() const
{
    std::vector<std::string> all = warnings_;
    for (std::string& warning : data_.textures.warnings()) {
        all.push_back(std::move(warning));
    }
    return all;
}

}  // namespace eye_render
