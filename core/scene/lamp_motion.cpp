#include "scene/lamp_motion.h"

#include "scene/motion.h"
#include "scene/transform.h"

#include <Imath/ImathMatrixAlgo.h>

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

constexpr std::array numbers{&LampSettings::radius,         &LampSettings::angle_rad,
                             &LampSettings::spot_angle_rad, &LampSettings::spot_blend,
                             &LampSettings::size_x,         &LampSettings::size_y,
                             &LampSettings::spread_rad};

[[nodiscard]] V3f row(const M44f& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }

// From the light's axes, which are unit and orthogonal whatever its matrix is.
[[nodiscard]] Imath::Quatf turn_of(const Lamp& lamp)
{
    const V3f& x = lamp.axis_x;
    const V3f& y = lamp.axis_y;
    const V3f& z = lamp.axis_z;
    return Imath::extractQuat(
        M44f(x.x, x.y, x.z, 0, y.x, y.y, y.z, 0, z.x, z.y, z.z, 0, 0, 0, 0, 1));
}

[[nodiscard]] V3f scale_along_axes(const M44f& world_from_light, const Lamp& lamp)
{
    const V3f y = row(world_from_light, 1);
    // Its pictures are mirrored with it.
    const float side = lamp.axis_y.dot(y) < 0.0f ? -1.0f : 1.0f;
    return {row(world_from_light, 0).length(), side * y.length(),
            row(world_from_light, 2).length()};
}

}  // namespace

LampMotion::LampMotion(const std::vector<LampPose>& poses, const V3d& eye_position_world)
{
    for (const LampPose& given : poses) {
        Pose pose{.settings = given.settings, .lamp = {}, .turn = {}, .scale = {}};
        pose.settings.world_from_light =
            to_float(relative_to_eye(given.world_from_light, eye_position_world));
        pose.lamp = make_lamp(pose.settings);
        pose.turn = turn_of(pose.lamp);
        pose.scale = scale_along_axes(pose.settings.world_from_light, pose.lamp);
        poses_.push_back(pose);
    }
}

MovedLamp LampMotion::at(float time) const
{
    const MotionPlace place = motion_place(poses_.size(), time);
    const Pose& before = poses_[place.step];
    const Pose& after = poses_[place.step + 1];
    const auto between = [weight = place.weight](const auto& a, const auto& b) {
        return a + (b - a) * weight;
    };
    LampSettings settings = before.settings;
    settings.color = between(before.settings.color, after.settings.color);
    for (const auto number : numbers) {
        // Stays within the bounds that both are in.
        settings.*number =
            std::lerp(before.settings.*number, after.settings.*number, place.weight);
    }
    const V3f scale = between(before.scale, after.scale);
    const V3f position = between(before.lamp.position, after.lamp.position);
    const auto axes = Imath::slerpShortestArc(before.turn, after.turn, place.weight).toMatrix33();
    M44f& matrix = settings.world_from_light;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            matrix[i][j] = axes[i][j] * scale[i];
        }
        matrix[3][i] = position[i];
    }
    return {make_lamp(settings), matrix};
}

bool LampMotion::may_be_met() const
{
    return std::ranges::any_of(poses_, [](const Pose& pose) { return !pose.lamp.is_delta; });
}

float LampMotion::reach_from(const V3f& p_world) const
{
    float reach = 0.0f;
    for (const Pose& pose : poses_) {
        const float own =
            std::max(pose.lamp.radius, std::hypot(pose.lamp.half_x, pose.lamp.half_y));
        reach = std::max(reach, (pose.lamp.position - p_world).length() + own);
    }
    return reach;
}

}  // namespace eye_render
