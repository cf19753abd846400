#include "render/nearest_depth.h"

#include <Imath/ImathBox.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace eye_render {

namespace {

// Distance along the viewing axis of the nearest corner of the box, not nearer than the clipping
// plane; infinity for a box that is behind it.
double nearest_depth(const Imath::Box3f& box,
                     const M44d& world_from_object,
                     const CameraFrame& frame)
{
    const M44d camera_from_object = world_from_object * frame.camera_from_world();
    double nearest_corner = std::numeric_limits<double>::infinity();
    double farthest_corner = -nearest_corner;
    for (int corner = 0; corner < 8; ++corner) {
        const V3d p_object((corner & 1) != 0 ? box.max.x : box.min.x,
                           (corner & 2) != 0 ? box.max.y : box.min.y,
                           (corner & 4) != 0 ? box.max.z : box.min.z);
        const double depth = -(p_object * camera_from_object).z;
        nearest_corner = std::min(nearest_corner, depth);
        farthest_corner = std::max(farthest_corner, depth);
    }
    return farthest_corner > frame.clip_near ? std::max(nearest_corner, frame.clip_near)
                                             : std::numeric_limits<double>::infinity();
}

// Of a lamp that the camera sees; infinity for others, and for the sun.
double nearest_depth(const LampData& lamp, const CameraFrame& frame)
{
    const LampSettings& settings = lamp.settings;
    const bool is_area = settings.kind == LampKind::Area;
    if (!settings.visibility.to_camera || !settings.casts_shadow ||
        settings.kind == LampKind::Sun || (!is_area && settings.radius == 0.0f)) {
        return std::numeric_limits<double>::infinity();
    }
    M44d place = lamp.world_from_light;
    V3f half(0.5f * settings.size_x, 0.5f * settings.size_y, 0.0f);
    if (!is_area) {  // a ball, whatever its scale
        place.setTranslation(V3d(place[3][0], place[3][1], place[3][2]));
        half = V3f(settings.radius);
    }
    return nearest_depth({-half, half}, place, frame);
}

}  // namespace

double nearest_depth(const SceneData& scene, const CameraFrame& frame)
{
    std::vector<Imath::Box3f> bounds;
    bounds.reserve(scene.geometries.size());
    for (const Geometry& geometry : scene.geometries) {
        bounds.push_back(bounds_of(geometry));
    }
    double nearest = std::numeric_limits<double>::infinity();
    for (const InstanceData& instance : scene.instances) {
        const Imath::Box3f& box = bounds[instance.geometry];
        if (box.isEmpty()) {
            continue;
        }
        nearest = std::min(nearest, nearest_depth(box, instance.world_from_object, frame));
        for (const M44d& place : instance.motion) {
            nearest = std::min(nearest, nearest_depth(box, place, frame));
        }
    }
    for (const LampData& lamp : scene.lamps) {
        nearest = std::min(nearest, nearest_depth(lamp, frame));
    }
    return nearest;
}

}  // namespace eye_render
