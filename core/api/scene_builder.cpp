#include "api/scene_builder.h"

#include "api/scene_resources.h"
#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eye_render {

namespace {

void require_finite(const std::string& what, const M44d& matrix)
{
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            if (!std::isfinite(matrix[i][j])) {
                throw std::invalid_argument(what + " has an entry that is not finite");
            }
        }
    }
}

// The sun of a sky that is laid out as the world is; one that is turned by other nodes is found by
// sampling alone.
std::optional<SunDisc> sun_above(const NodeGraph& graph)
{
    for (std::size_t i = 0; i < graph.size(); ++i) {
        const NodeGraph::Node& node = graph.node(i);
        if (node.type->name == "TEX_SKY" &&
            std::holds_alternative<std::monostate>(node.inputs.front())) {
            return sun_disc(node.options);
        }
    }
    return std::nullopt;
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

std::size_t SceneBuilder::add_mesh(Mesh mesh)
{
    require_unleased();
    validate(mesh);
    const std::size_t dropped = drop_broken_triangles(mesh);
    if (dropped > 0) {
        warnings_.push_back("mesh '" + mesh.name + "': " + std::to_string(dropped) +
                            " triangles with a corner that is not finite are left out");
    }
    data_.meshes.push_back(std::move(mesh));
    return data_.meshes.size() - 1;
}

std::size_t SceneBuilder::add_material(const std::string& name,
                                       const NodeGraph& graph,
                                       const std::optional<NodeOutput>& surface,
                                       const std::optional<NodeOutput>& displacement,
                                       int pass_index,
                                       const AovsByName& aovs)
{
    require_unleased();
    SceneResources resources(data_);
    Material material =
        make_material(name, graph, surface, displacement, resources, numbered(aovs));
    material.pass_index = pass_index;
    data_.materials.push_back(std::move(material));
    return data_.materials.size() - 1;
}

void SceneBuilder::add_instance(InstanceData instance)
{
    require_unleased();
    require_index("mesh", instance.mesh, data_.meshes.size());
    require_finite("world_from_object of mesh '" + data_.meshes[instance.mesh].name + "'",
                   instance.world_from_object);
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
    require_finite("world_from_light of lamp '" + lamp.name + "'", lamp.world_from_light);
    if (surface) {
        SceneResources resources(data_);
        Material nodes = make_material(lamp.name, graph, surface, std::nullopt, resources);
        if (const auto constant = nodes.surface.constant_emission()) {
            lamp.settings.color *= *constant;
        } else {
            lamp.nodes = std::move(nodes);
        }
    }
    try {
        static_cast<void>(make_lamp(lamp.settings));  // for its checks
    } catch (const std::invalid_argument& error) {
        throw std::invalid_argument("lamp '" + lamp.name + "': " + error.what());
    }
    data_.lamps.push_back(std::move(lamp));
}

void SceneBuilder::set_world(const NodeGraph& graph,
                             const std::optional<NodeOutput>& surface,
                             const AovsByName& aovs)
{
    require_unleased();
    SceneResources resources(data_);
    data_.world = make_material("world", graph, surface, std::nullopt, resources, numbered(aovs));
    data_.world_sun = sun_above(graph);
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

void SceneBuilder::set_camera(const CameraFrame& frame)
{
    require_unleased();
    // Also refuses NaN. A sheared parent may tilt the axes against each other, but not flatten
    // them.
    if (!(std::abs(frame.axis_x.dot(frame.axis_y.cross(frame.axis_z))) > 1e-6)) {
        throw std::invalid_argument(
            "the camera's axes span no space; expected an invertible matrix");
    }
    for (const double coordinate :
         {frame.position_world.x, frame.position_world.y, frame.position_world.z}) {
        require_range("camera position", coordinate, -1e30, 1e30, "units");
    }
    require_range("resolution x", frame.width_px, 1, 65536, "px");
    require_range("resolution y", frame.height_px, 1, 65536, "px");
    require_range("border x0", frame.border.x0, 0, frame.width_px - 1, "px");
    require_range("border y0", frame.border.y0, 0, frame.height_px - 1, "px");
    require_range("border x1", frame.border.x1, frame.border.x0 + 1, frame.width_px, "px");
    require_range("border y1", frame.border.y1, frame.border.y0 + 1, frame.height_px, "px");
    // 1e4 is a field of view of 179.99 degrees: wider is no perspective camera.
    require_range("slope_left", frame.slope_left, -1e4, 1e4, "");
    require_range("slope_bottom", frame.slope_bottom, -1e4, 1e4, "");
    require_range("slope_right", frame.slope_right, frame.slope_left + 1e-9, 1e4, "");
    require_range("slope_top", frame.slope_top, frame.slope_bottom + 1e-9, 1e4, "");
    require_range("clip near", frame.clip_near, 0.0, 1e30, "units");
    require_range("clip far", frame.clip_far, frame.clip_near, 1e30, "units");
    require_range("metres_per_unit", frame.metres_per_unit, 1e-9, 1e9, "m");
    camera_ = frame;
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
