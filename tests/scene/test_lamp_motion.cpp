// Lamps that move while the shutter is open.

#include "scene/lamp_motion.h"

#include <gtest/gtest.h>

#include <numbers>

namespace eye_render {
namespace {

LampPose area_at(const V3d& place, double turn_deg, float size)
{
    LampPose pose{{.kind = LampKind::Area, .color = Color3f(size), .size_x = size, .size_y = 1.0f},
                  M44d()};
    pose.world_from_light.rotate(V3d(0.0, 0.0, turn_deg * std::numbers::pi / 180.0));
    for (int i = 0; i < 3; ++i) {
        pose.world_from_light[3][i] = place[i];
    }
    return pose;
}

TEST(LampMotion, a_lamp_goes_straight_turns_evenly_and_grows_evenly)
{
    const V3d eye(100.0, 0.0, 0.0);
    const LampMotion motion({area_at({100.0, 0.0, 5.0}, 0.0, 1.0f),
                             area_at({102.0, 0.0, 5.0}, 60.0, 2.0f),
                             area_at({102.0, 4.0, 5.0}, 60.0, 2.0f)},
                            eye);
    const MovedLamp quarter = motion.at(0.25f);
    EXPECT_LT((quarter.lamp.position - V3f(1.0f, 0.0f, 5.0f)).length(), 1e-5f);
    const float angle = std::numbers::pi_v<float> / 6.0f;
    EXPECT_LT((quarter.lamp.axis_x - V3f(std::cos(angle), std::sin(angle), 0.0f)).length(), 1e-5f);
    EXPECT_FLOAT_EQ(quarter.lamp.half_x, 0.75f);
    EXPECT_FLOAT_EQ(quarter.lamp.half_y, 0.5f);
    // As bright as the lamp of this size and energy is.
    EXPECT_FLOAT_EQ(quarter.lamp.emission.x, 1.5f / (std::numbers::pi_v<float> * 1.5f));
    EXPECT_LT((motion.at(0.75f).lamp.position - V3f(2.0f, 2.0f, 5.0f)).length(), 1e-5f);
    EXPECT_LT((motion.at(1.0f).lamp.position - V3f(2.0f, 4.0f, 5.0f)).length(), 1e-5f);
}

TEST(LampMotion, its_reach_holds_all_of_its_places)
{
    const LampMotion motion(
        {area_at({0.0, 0.0, 0.0}, 0.0, 2.0f), area_at({6.0, 0.0, 0.0}, 45.0, 1.0f)}, V3d(0.0));
    const V3f middle = motion.at(0.5f).lamp.position;
    const float reach = motion.reach_from(middle);
    for (float time = 0.0f; time <= 1.0f; time += 0.0625f) {
        const Lamp lamp = motion.at(time).lamp;
        for (const float x : {-1.0f, 1.0f}) {
            for (const float y : {-1.0f, 1.0f}) {
                const V3f corner = lamp.position + lamp.axis_x * (x * lamp.half_x) +
                                   lamp.axis_y * (y * lamp.half_y);
                EXPECT_LE((corner - middle).length(), reach * 1.0001f) << time;
            }
        }
    }
    EXPECT_LT(reach, 4.3f);
}

TEST(LampMotion, one_that_keeps_still_in_a_number_keeps_it_exactly)
{
    LampPose open = area_at({0.0, 0.0, 0.0}, 0.0, 0.3f);
    LampPose closed = area_at({1.0, 0.0, 0.0}, 0.0, 0.3f);
    for (LampPose* pose : {&open, &closed}) {
        pose->settings.kind = LampKind::Spot;
        pose->settings.spot_angle_rad = std::numbers::pi_v<float>;
        pose->settings.spot_blend = 1.0f;
    }
    const LampMotion motion({open, closed}, V3d(0.0));
    for (float time = 0.0f; time <= 1.0f; time += 0.01f) {
        EXPECT_EQ(motion.at(time).lamp.one_minus_cos_half_angle,
                  make_lamp(open.settings).one_minus_cos_half_angle);
    }
}

}  // namespace
}  // namespace eye_render
