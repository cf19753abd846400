// The lamps of a scene, and what their nodes make of their light.

#include "base/magnitude.h"
#include "base/sobol.h"
#include "base/warp.h"
#include "scene/light_path.h"
#include "scene/scene.h"
#include "scene/transform.h"

namespace eye_render {

void Scene::add_lamps()
{
    std::vector<std::uint32_t> visible;
    std::vector<std::uint32_t> seen_by_camera;
    for (const LampData& data : data_.lamps) {
        const auto index = static_cast<std::uint32_t>(lamps_.size());
        LampSettings settings = data.settings;
        settings.world_from_light =
            to_float(relative_to_eye(data.world_from_light, frame_.eye_position_world));
        lamps_.push_back(make_lamp(settings));
        lamp_spaces_.emplace_back(data.world_from_light, settings.has_own_space);
        Lamp& lamp = lamps_.back();
        lamp.brightness = brightest_factor(index);
        if (lamp.kind == LampKind::Sun && is_cut_off_from_infinity()) {
            lamp.emission = Color3f(0.0f);
        }
        // Rays would lose a lamp without shadows behind what it shines through: sampling alone
        // finds it.
        if (!lamp.is_delta && lamp.casts_shadow) {
            visible.push_back(index);
            if (lamp.visibility.to_camera) {
                seen_by_camera.push_back(index);
            }
        }
    }
    visible_lamps_ = LampTree(lamps_, visible);
    camera_lamps_ = LampTree(lamps_, seen_by_camera);
}

Color3f Scene::lamp_factor(std::uint32_t index,
                           const LampSight& sight,
                           const PathState& path) const
{
    const std::optional<Material>& nodes = data_.lamps[index].nodes;
    if (!nodes) {
        return Color3f(1.0f);
    }
    const LampAttributes at(lamps_[index], lamp_spaces_[index], sight, frame_);
    const ShadingPoint point = at.shading_point();
    PathState met = path;
    met.length = sight.distance;
    return nodes->surface.emission({.point = point, .attributes = at, .path = met});
}

// Looked at from all around, a unit away; 1 where that finds no light.
float Scene::brightest_factor(std::uint32_t index) const
{
    if (!data_.lamps[index].nodes) {
        return 1.0f;
    }
    constexpr std::uint32_t looks = 64;
    float brightest = 0.0f;
    for (std::uint32_t i = 0; i < looks; ++i) {
        const auto u = sobol_4d(0, i, 0);
        const V3f wi = sample_uniform_sphere({u[0], u[1]});
        const LampSight sight{
            .p_lit_world = lamps_[index].position - wi, .wi = wi, .distance = 1.0f};
        brightest =
            std::max(brightest, luminance(magnitude(lamp_factor(index, sight, light_path))));
    }
    return brightest > 0.0f ? brightest : 1.0f;
}

}  // namespace eye_render
