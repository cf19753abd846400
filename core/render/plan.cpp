#include "render/plan.h"

#include "render/blur_bound.h"
#include "render/nearest_depth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace eye_render {

namespace {

// Blur diameter in pixels.
double largest_blur_px(const SceneData& scene,
                       const CameraFrame& frame,
                       const std::vector<CameraFrame>& camera_motion,
                       const EyeModel& eye,
                       bool chromatic)
{
    if (eye.pupil_diameter_m() <= 0.0) {
        return 0.0;
    }
    double nearest = nearest_depth(scene, frame);
    for (const CameraFrame& pose : camera_motion) {
        nearest = std::min(nearest, nearest_depth(scene, pose));
    }
    const double nearest_m = nearest * frame.metres_per_unit;
    if (nearest_m <= 0.0) {
        return std::numeric_limits<double>::infinity();
    }
    const V2d pixel = frame.pixel_slope_size();
    return largest_blur_slope(eye, frame, nearest_m, chromatic) / std::min(pixel.x, pixel.y);
}

std::string quoted_list(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) {
        text += (text.empty() ? "" : ", ") + (name.empty() ? "the first" : "'" + name + "'");
    }
    return text.empty() ? "none" : text;
}

template <typename Lookup>
std::vector<std::string> names_of(const std::vector<int>& layers, const Lookup& names)
{
    std::vector<std::string> result;
    result.reserve(layers.size());
    for (const int layer : layers) {
        result.push_back(names[static_cast<std::size_t>(layer)]);
    }
    return result;
}

void count_primitives(RenderPlan& plan, const Geometry& geometry)
{
    if (const Mesh* mesh = std::get_if<Mesh>(&geometry)) {
        plan.triangles += mesh->triangles.size();
    } else if (const Curves* curves = std::get_if<Curves>(&geometry)) {
        plan.strands += curves->first_keys.size();
    } else {
        plan.points += std::get<Points>(geometry).points.size();
    }
}

void plan_lights(RenderPlan& plan, const SceneData& scene)
{
    for (const LampData& lamp : scene.lamps) {
        switch (lamp.settings.kind) {
        case LampKind::Point: ++plan.point_lamps; break;
        case LampKind::Sun: ++plan.suns; break;
        case LampKind::Spot: ++plan.spots; break;
        case LampKind::Area: ++plan.area_lamps; break;
        }
        plan.moving_lamps += lamp.motion.empty() ? 0 : 1;
    }
    plan.environment_table = !scene.world.surface.constant_emission();
}

std::string volumes_text(const RenderPlan& plan)
{
    std::string text;
    if (plan.filled_objects > 0) {
        text = "in " + std::to_string(plan.filled_objects) + " objects";
    }
    if (plan.filled_world) {
        text += std::string(text.empty() ? "" : " and ") + "in the world";
    }
    return text.empty() ? "none" : text;
}

}  // namespace

RenderPlan make_plan(const SceneData& scene, std::vector<PassRequest> passes)
{
    RenderPlan plan;
    std::vector<std::size_t> uses(scene.geometries.size(), 0);
    std::vector<const Material*> materials;
    for (const InstanceData& instance : scene.instances) {
        count_primitives(plan, scene.geometries[instance.geometry]);
        plan.instanced_meshes += ++uses[instance.geometry] == 2 ? 1 : 0;
        plan.moving_objects += instance.motion.empty() ? 0 : 1;
        for (const std::size_t material : instance.materials) {
            materials.push_back(&scene.materials[material]);
        }
        plan.shadow_catcher = plan.shadow_catcher || instance.is_shadow_catcher;
        plan.filled_objects +=
            std::ranges::any_of(
                instance.materials,
                [&](std::size_t material) { return scene.materials[material].has_volume(); })
                ? 1
                : 0;
    }
    plan.placements = scene.instances.size();
    plan.deforming_meshes =
        static_cast<std::size_t>(std::ranges::count_if(scene.geometries, deforms));
    for (const Material* material : materials) {
        plan.emissive_meshes = plan.emissive_meshes || material->surface.may_emit();
        plan.transparent_shadows =
            plan.transparent_shadows || material->surface.may_be_transparent();
    }
    plan.images = static_cast<std::size_t>(scene.textures.size());
    plan.uv_layers = names_of(uv_layers_read(materials), scene.uv_layer_names);
    plan.attributes = names_of(attributes_read(materials), scene.attribute_names);
    plan_lights(plan, scene);
    plan.filled_world = scene.world.has_volume();
    plan.passes = std::move(passes);
    return plan;
}

void plan_lens(RenderPlan& plan,
               const SceneData& scene,
               const CameraFrame& frame,
               const EyeModel& eye,
               bool chromatic,
               bool stiles_crawford,
               const std::vector<CameraFrame>& camera_motion)
{
    plan.moving_camera = !camera_motion.empty();
    plan.largest_blur_px = largest_blur_px(scene, frame, camera_motion, eye, chromatic);
    // Narrower blur disappears in the pixel filter, so that a pull of focus shows no step where
    // the lens comes in: at an edge from black to white it is 0.0006 of the contrast, 0.4 of the
    // 256 levels of sRGB, where blur of a pixel would bring 0.037 and 19 levels. NaN falls to the
    // lens, which costs time but never blur.
    constexpr double unseen_px = 0.125;
    plan.lens = !(plan.largest_blur_px < unseen_px);
    plan.chromatic = plan.lens && chromatic && eye.is_chromatic();
    plan.stiles_crawford = plan.lens && stiles_crawford;
}

std::string RenderPlan::text() const
{
    std::ostringstream out;
    out << "geometry: " << triangles << " triangles"
        << (strands > 0 ? ", " + std::to_string(strands) + " strands" : "")
        << (points > 0 ? ", " + std::to_string(points) + " points" : "") << " in " << placements
        << " objects, " << instanced_meshes << " meshes instanced\n";
    out << "images: " << images << (images == 0 ? " (OpenImageIO not started)" : "")
        << "; UV layers read: " << quoted_list(uv_layers)
        << "; attributes read: " << quoted_list(attributes) << '\n';
    out << "lights: " << point_lamps << " point, " << suns << " sun, " << spots << " spot, "
        << area_lamps << " area; emissive meshes: " << (emissive_meshes ? "yes" : "no")
        << "; environment table: " << (environment_table ? "yes" : "no") << '\n';
    out << "shadows: " << (transparent_shadows ? "materials may pass light" : "opaque") << '\n';
    out << "volumes: " << volumes_text(*this) << '\n';
    out << "lens: " << (lens ? "sampled" : "pinhole") << ", largest blur at most "
        << largest_blur_px << " px; wavelengths: " << (chromatic ? "sampled" : "one")
        << "; Stiles-Crawford: " << (stiles_crawford ? "on" : "off") << '\n';
    out << "motion: ";
    if (moves()) {
        out << moving_objects << " objects move, " << deforming_meshes << " meshes deform, "
            << moving_lamps << " lamps move, camera " << (moving_camera ? "moves" : "still")
            << (motion_blur ? "" : "; not blurred") << '\n';
    } else {
        out << "none\n";
    }
    if (shadow_catcher) {
        out << "shadow catchers: a second path where the camera sees one\n";
    }
    out << "passes:";
    for (const PassRequest& pass : passes) {
        out << ' ' << pass.name();
    }
    return out.str() + '\n';
}

}  // namespace eye_render
