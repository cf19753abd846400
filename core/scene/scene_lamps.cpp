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
            continue;
        }
        bool may_be_met = !lamp.is_delta;
        if (!data.motion.empty()) {
            add_motion_of_lamp(index);
            may_be_met = lamp_motions_[index]->may_be_met();
        }
        // Rays would lose a lamp without shadows behind what it shines through: sampling alone
        // finds it.
        if (may_be_met && lamp.casts_shadow) {
            visible.push_back(index);
            if (lamp.visibility.to_camera) {
                seen_by_camera.push_back(index);
            }
        }
    }
    visible_lamps_ = LampTree(lamps_, visible);
    camera_lamps_ = LampTree(lamps_, seen_by_camera);
}

void Scene::add_motion_of_lamp(std::uint32_t index)
{
    lamp_motions_.resize(data_.lamps.size());
    lamp_motions_[index].emplace(data_.lamps[index].motion, frame_.eye_position_world);
    lamps_[index].moves = true;
    lamps_[index].reach = lamp_motions_[index]->reach_from(lamps_[index].position);
}

Color3f Scene::lamp_factor(std::uint32_t index,
                           const Room<MovedLamp>& moved,
                           const LampSight& sight,
                           const PathState& path) const
{
    const std::optional<Material>& nodes = data_.lamps[index].nodes;
    if (!nodes) {
        return Color3f(1.0f);
    }
    const auto factor = [&](const Lamp& lamp, const LampSpace& space) {
        const LampAttributes at(lamp, space, sight, frame_);
        const ShadingPoint point = at.shading_point();
        PathState met = path;
        met.length = sight.distance;
        return nodes->surface.emission({.point = point, .attributes = at, .path = met});
    };
    if (!moved) {
        return factor(lamps_[index], lamp_spaces_[index]);
    }
    const M44d world_from_light =
        relative_to_eye(M44d(moved->world_from_light), -frame_.eye_position_world);
    return factor(moved->lamp,
                  LampSpace(world_from_light, data_.lamps[index].settings.has_own_space));
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
            std::max(brightest, luminance(magnitude(lamp_factor(index, {}, sight, light_path))));
    }
    return brightest > 0.0f ? brightest : 1.0f;
}

}  // namespace eye_render
