// A scene as plain data, before anything is built from it. World positions are double and
// absolute; what is built (scene.h) is float and relative to the eye.

#pragma once

#include "base/matte_id.h"
#include "scene/geometry.h"
#include "scene/lamp.h"
#include "scene/light_links.h"
#include "scene/light_origin.h"
#include "scene/textures.h"
#include "scene/visibility.h"
#include "shading/material.h"
#include "shading/sky.h"

#include <optional>
#include <string>
#include <vector>

namespace eye_render {

// A property that takes the place of an attribute which the mesh lacks.
struct ObjectProperty {
    int attribute = 0;
    Color4f value{0.0f};
};

// What nodes are told of an object, besides its place.
struct ObjectLook {
    Color4f color{1.0f};
    float pass_index = 0.0f;
    float random = 0.0f;  // of this instance, in [0, 1)
    std::vector<ObjectProperty> properties{};
};

struct InstanceData {
    std::size_t geometry = 0;
    M44d world_from_object;              // row-vector convention
    std::vector<std::size_t> materials;  // one a slot of a mesh, else one; empty: a grey one
    ObjectLook look{};
    Visibility visibility{};
    bool is_holdout = false;  // cut out of the picture
    bool is_shadow_catcher = false;
    float terminator_cosine = 0.0f;  // of light that shadow_terminator.h softens; 0 for none
    MatteIds matte{};
    int light_group = no_light_group;
    LightLinks links{};  // of its own light
    LinkedObject linked{};
    // Places at the times of motion.h; empty: still. `world_from_object` is that at the shutter's
    // middle.
    std::vector<M44d> motion{};
};

// A lamp as it is at one time.
struct LampPose {
    LampSettings settings;  // world_from_light is left out of account
    M44d world_from_light;
};

struct LampData {
    std::string name;
    int light_group = no_light_group;
    LightLinks links{};
    LampSettings settings;  // as those of a pose
    M44d world_from_light;
    // Multiplies its light, where that is not one colour (which is part of the settings).
    std::optional<Material> nodes{};
    // At the times of motion.h, alike but for numbers; empty: still. The above is half way.
    std::vector<LampPose> motion{};
};

struct SceneData {
    std::vector<Geometry> geometries;
    std::vector<InstanceData> instances;
    std::vector<Material> materials;
    std::vector<LampData> lamps;
    Material world;
    std::optional<SunDisc> world_sun;                   // of the sky, to be aimed at
    WorkingSpace working_space = WorkingSpace::Rec709;  // of all colours, those of textures too
    TextureSet textures{working_space};
    // Names behind the layer numbers of materials. The empty name asks for a mesh's first layer.
    std::vector<std::string> uv_layer_names{""};
    std::vector<std::string> attribute_names;
    // Names behind the numbers of light groups, and of values that materials write out.
    std::vector<std::string> light_groups;
    std::vector<std::string> aovs;
    int world_light_group = no_light_group;
    Visibility world_visibility{};  // of its light; what fills it hides from nothing
};

// The layer numbers that some of the materials reads, ascending and without repeats.
[[nodiscard]] std::vector<int> uv_layers_read(const std::vector<const Material*>& materials);
[[nodiscard]] std::vector<int> attributes_read(const std::vector<const Material*>& materials);

}  // namespace eye_render
