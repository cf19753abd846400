// A lamp that moves, turns, or changes in size or brightness while the shutter is open: between
// its known poses it goes straight and turns evenly, and its numbers change evenly.

#pragma once

#include "scene/lamp.h"
#include "scene/scene_data.h"

#include <Imath/ImathQuat.h>

#include <vector>

namespace eye_render {

// World space relative to the eye.
struct MovedLamp {
    Lamp lamp;
    M44f world_from_light;
};

class LampMotion {
public:
    // At the times of motion.h, at least two.
    LampMotion(const std::vector<LampPose>& poses, const V3d& eye_position_world);

    [[nodiscard]] MovedLamp at(float time) const;
    // True if rays meet the lamp at some time.
    [[nodiscard]] bool may_be_met() const;
    // Radius of a ball around the point that holds the lamp at all times.
    [[nodiscard]] float reach_from(const V3f& p_world) const;

private:
    struct Pose {
        LampSettings settings;
        Lamp lamp;
        Imath::Quatf turn;
        V3f scale;
    };
    std::vector<Pose> poses_;
};

}  // namespace eye_render
