// What the ray through the centres of pixel and pupil meets, for the passes that no blur mixes.

#pragma once

#include "eye/eye_model.h"
#include "render/camera_motion.h"
#include "render/pass_layout.h"
#include "scene/scene.h"

#include <span>

namespace eye_render {

struct ChiefRays {
    const Scene& scene;
    const CameraFrame& frame;
    const EyeModel& eye;
    float least_alpha = 0.5f;  // of what is met: rays pass what is clearer than that
    const CameraMotion* camera_motion = nullptr;  // null: `frame` at all times
};

// Fills the values of one pixel, one a channel of the layout's chief passes.
void trace_chief_ray(const ChiefRays& rays,
                     const V2d& raster,
                     const PassLayout& layout,
                     std::span<float> values);

// Distance along the viewing axis, in metres, of what the chief ray of slope `chief_slope` meets;
// infinity when it meets nothing.
[[nodiscard]] double distance_along_m(const ChiefRays& rays, const V2d& chief_slope);

}  // namespace eye_render
