// The part of eyecore.Scene that takes lamps.

#include "bind_scene.h"

#include <optional>
#include <variant>

namespace eye_render {

namespace {

// Keyword arguments go to the members of the same name.
void set_lamp_member(LampSettings& settings, const std::string& name, const py::handle& value)
{
    using Member =
        std::variant<float LampSettings::*, bool LampSettings::*, LampShape LampSettings::*>;
    const auto member = named<Member>("setting of a light", name,
                                      {{"radius", &LampSettings::radius},
                                       {"soft_falloff", &LampSettings::soft_falloff},
                                       {"angle_rad", &LampSettings::angle_rad},
                                       {"spot_angle_rad", &LampSettings::spot_angle_rad},
                                       {"spot_blend", &LampSettings::spot_blend},
                                       {"spot_cosine_falloff", &LampSettings::spot_cosine_falloff},
                                       {"shape", &LampSettings::shape},
                                       {"size_x", &LampSettings::size_x},
                                       {"size_y", &LampSettings::size_y},
                                       {"spread_rad", &LampSettings::spread_rad},
                                       {"casts_shadow", &LampSettings::casts_shadow},
                                       {"has_own_space", &LampSettings::has_own_space}});
    if (const auto* number = std::get_if<float LampSettings::*>(&member)) {
        settings.** number = value.cast<float>();
    } else if (const auto* flag = std::get_if<bool LampSettings::*>(&member)) {
        settings.** flag = value.cast<bool>();
    } else {
        settings.shape =
            named<LampShape>("shape", value.cast<std::string>(),
                             {{"RECTANGLE", LampShape::Rectangle}, {"DISK", LampShape::Disk}});
    }
}

// Of what it does not name the pose is as it was.
void place(LampPose& pose, const std::string& lamp, const py::dict& told)
{
    for (const auto& [key, value] : told) {
        const auto name = key.cast<std::string>();
        if (name == "world_from_light") {
            pose.world_from_light = matrix_from(value.cast<Array<double>>(), name);
        } else if (name == "color") {
            pose.settings.color = color_from("color of light '" + lamp + "'", value);
        } else {
            set_lamp_member(pose.settings, name, value);
        }
    }
}

void add_light(SceneBuilder& scene,
               const std::string& name,
               const std::string& kind,
               const Array<double>& world_from_light,
               const py::object& color,
               const std::optional<NodeSocket>& surface,
               const std::vector<std::string>& hidden_from,
               const std::string& light_group,
               std::uint64_t lit_classes,
               int blocker_set,
               const std::vector<py::dict>& motion,
               const py::kwargs& settings)
{
    LampData lamp{.name = name,
                  .settings = {},
                  .world_from_light = matrix_from(world_from_light, "world_from_light")};
    lamp.settings.kind = named<LampKind>("kind", kind,
                                         {{"POINT", LampKind::Point},
                                          {"SUN", LampKind::Sun},
                                          {"SPOT", LampKind::Spot},
                                          {"AREA", LampKind::Area}});
    lamp.settings.color = color_from("color of light '" + name + "'", color);
    for (const auto& [key, value] : settings) {
        set_lamp_member(lamp.settings, key.cast<std::string>(), value);
    }
    lamp.settings.visibility = visibility_from(hidden_from);
    lamp.light_group = scene.light_group(light_group);
    lamp.links = links_from(lit_classes, blocker_set);
    for (const py::dict& told : motion) {
        LampPose pose{lamp.settings, lamp.world_from_light};
        place(pose, name, told);
        lamp.motion.push_back(std::move(pose));
    }
    if (surface) {
        scene.add_lamp(std::move(lamp), *surface->graph, surface->output);
    } else {
        scene.add_lamp(std::move(lamp));
    }
}

}  // namespace

void bind_lights(SceneClass& scene)
{
    using namespace py::literals;

    scene.def(
        "add_light", &add_light, "name"_a, "kind"_a, "world_from_light"_a, "color"_a,
        py::kw_only(), "surface"_a = py::none(),
        "hidden_from"_a = std::vector<std::string>{"CAMERA"}, "light_group"_a = "",
        "lit_classes"_a = LightLinks{}.lit_classes, "blocker_set"_a = 0, "motion"_a = py::list(),
        "kind: POINT, SUN, SPOT or AREA; color is colour times energy: W, for the sun W/m^2.\n"
        "Settings by keyword: radius, soft_falloff, angle_rad, spot_angle_rad, spot_blend,\n"
        "spot_cosine_falloff, shape (RECTANGLE or DISK), size_x, size_y, spread_rad,\n"
        "casts_shadow, has_own_space (for its nodes). surface: an output of an Emission node, "
        "which multiplies the colour;\n"
        "hidden_from: CAMERA, DIFFUSE, GLOSSY, TRANSMISSION rays. lit_classes (bits), blocker_set "
        "(0: all):\n"
        "what it lights, and what throws its shadows, by the numbers of add_instances. motion:\n"
        "world_from_light, color and settings that change, a dict for each of equally spaced "
        "times\n"
        "from the shutter's opening to its close.");
}

}  // namespace eye_render
