// eyecore.Scene: lights and camera from NumPy arrays.

#include "bind_scene.h"

#include <cmath>
#include <optional>

namespace eye_render {

namespace {

// world_from_camera and slope_bounds.
using GivenPose = std::pair<Array<double>, std::array<double, 4>>;

void place(CameraFrame& frame, const GivenPose& pose)
{
    const auto& [world_from_camera, slope_bounds] = pose;
    const M44d matrix = matrix_from(world_from_camera, "world_from_camera");
    const auto row = [&matrix](int i) { return V3d(matrix[i][0], matrix[i][1], matrix[i][2]); };
    frame.position_world = row(3);
    // A camera's scale means nothing, as in Blender.
    frame.axis_x = row(0).normalized();
    frame.axis_y = row(1).normalized();
    frame.axis_z = row(2).normalized();
    frame.slope_left = slope_bounds[0];
    frame.slope_right = slope_bounds[1];
    frame.slope_bottom = slope_bounds[2];
    frame.slope_top = slope_bounds[3];
}

void set_camera(SceneBuilder& scene,
                const Array<double>& world_from_camera,
                const std::array<double, 4>& slope_bounds,
                const std::array<int, 2>& resolution,
                const std::optional<std::array<int, 4>>& border,
                const std::array<double, 2>& clip,
                double metres_per_unit,
                const std::vector<GivenPose>& motion)
{
    CameraFrame frame;
    place(frame, {world_from_camera, slope_bounds});
    frame.width_px = resolution[0];
    frame.height_px = resolution[1];
    frame.border = border ? PixelBounds{(*border)[0], (*border)[1], (*border)[2], (*border)[3]}
                          : PixelBounds{0, 0, resolution[0], resolution[1]};
    frame.clip_near = clip[0];
    frame.clip_far = clip[1];
    frame.metres_per_unit = metres_per_unit;
    std::vector<CameraFrame> poses(motion.size(), frame);
    for (std::size_t step = 0; step < motion.size(); ++step) {
        place(poses[step], motion[step]);
    }
    scene.set_camera(frame, std::move(poses));
}

}  // namespace

Visibility visibility_from(const std::vector<std::string>& hidden_from)
{
    Visibility visibility;
    for (const std::string& ray : hidden_from) {
        visibility.*named<bool Visibility::*>("hidden_from", ray,
                                              {{"CAMERA", &Visibility::to_camera},
                                               {"DIFFUSE", &Visibility::to_diffuse},
                                               {"GLOSSY", &Visibility::to_glossy},
                                               {"TRANSMISSION", &Visibility::to_transmission},
                                               {"VOLUME_SCATTER", &Visibility::to_volume_scatter},
                                               {"SHADOW", &Visibility::to_shadow}}) = false;
    }
    return visibility;
}

LightLinks links_from(std::uint64_t lit_classes, int blocker_set)
{
    return {.lit_classes = lit_classes, .blocker_set = blocker_set};
}

void bind_scene(py::module_& m)
{
    using namespace py::literals;

    SceneClass scene(m, "Scene", "What is to be seen.");
    bind_materials(scene);
    bind_geometry(scene);
    bind_instances(scene);
    bind_lights(scene);
    scene
        .def(py::init([](const std::string& working_space) {
                 return std::make_shared<SceneBuilder>(
                     named<WorkingSpace>("working_space", working_space,
                                         {{"Linear Rec.709", WorkingSpace::Rec709},
                                          {"Linear Rec.2020", WorkingSpace::Rec2020},
                                          {"ACEScg", WorkingSpace::AcesCg}}));
             }),
             "working_space"_a = "Linear Rec.709",
             "working_space: what all colours are in that go in and come out, by Blender's names.")
        .def("set_camera", &set_camera, "world_from_camera"_a, "slope_bounds"_a, "resolution"_a,
             "border"_a = py::none(), "clip"_a = std::array<double, 2>{0.001, 1e9},
             "metres_per_unit"_a = 1.0, "motion"_a = py::list(),
             "slope_bounds: left, right, bottom, top of the full frame, as slopes; border: x0, "
             "y0,\n"
             "x1, y1 in pixels, x1 and y1 excluded, from the lower left; motion: "
             "(world_from_camera,\n"
             "slope_bounds) at equally spaced times from the shutter's opening to its close.")
        .def("uv_layers_read", &SceneBuilder::uv_layers_read, "materials"_a)
        .def("attributes_read", &SceneBuilder::attributes_read, "materials"_a);
}

}  // namespace eye_render
