// The plan: what this scene, seen by this eye, needs, found before anything is built from it. What
// is not in the plan is not exported, started, allocated or sampled.

#pragma once

#include "render/camera.h"
#include "render/passes.h"
#include "scene/scene_data.h"

#include <string>
#include <vector>

namespace eye_render {

struct RenderPlan {
    std::size_t triangles = 0;
    std::size_t strands = 0;
    std::size_t points = 0;
    std::size_t placements = 0;
    // Meshes, sets of strands or clouds of points that are placed more than once: built once, and
    // referred to from each place.
    std::size_t instanced_meshes = 0;
    std::size_t images = 0;              // 0: OpenImageIO is not started
    std::vector<std::string> uv_layers;  // read by some material; "" is a mesh's first layer
    std::vector<std::string> attributes;
    std::size_t point_lamps = 0;
    std::size_t suns = 0;
    std::size_t spots = 0;
    std::size_t area_lamps = 0;
    bool emissive_meshes = false;
    bool environment_table = false;    // the world differs by direction: importance sampled
    bool transparent_shadows = false;  // shadow rays must look at materials
    std::size_t filled_objects = 0;    // with a medium inside
    bool filled_world = false;         // a medium fills the world. Without media, paths keep none
    double largest_blur_px = 0.0;      // an upper bound over everything in view
    bool lens = false;                 // false: one ray through the pupil's centre serves
    bool chromatic = false;            // a wavelength for each path, if there is blur to show it
    bool stiles_crawford = false;      // the pupil is weighed, if there is blur to show it
    bool shadow_catcher = false;       // some object shows only its shadows
    std::size_t moving_objects = 0;    // while the shutter is open
    std::size_t deforming_meshes = 0;  // or strands or points
    std::size_t moving_lamps = 0;
    bool moving_camera = false;
    bool motion_blur = true;  // else what moves is for a pass alone
    std::vector<PassRequest> passes;

    [[nodiscard]] bool moves() const
    {
        return moving_objects > 0 || deforming_meshes > 0 || moving_lamps > 0 || moving_camera;
    }

    // One fact a line, for people.
    [[nodiscard]] std::string text() const;
};

// All of the plan but its lens, which waits for the eye.
[[nodiscard]] RenderPlan make_plan(const SceneData& scene, std::vector<PassRequest> passes);

// Adds what the eye shows of the scene: how much it blurs at most, whether that is to be seen, and
// with it what depends on the point of the pupil. `camera_motion`: its frames at the times of
// scene/motion.h, or nothing.
void plan_lens(RenderPlan& plan,
               const SceneData& scene,
               const CameraFrame& frame,
               const EyeModel& eye,
               bool chromatic = false,
               bool stiles_crawford = false,
               const std::vector<CameraFrame>& camera_motion = {});

}  // namespace eye_render
