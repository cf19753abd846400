#include "scene/scene.h"

#include "scene/barycentric.h"
#include "scene/look_at.h"
#include "scene/scene_probe.h"
#include "scene/transform.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

Ray passed_through(const Ray& ray, const SurfaceHit& hit)
{
    Ray rest = hit.ray_towards(ray.direction);
    rest.t_max = std::max(0.0f, ray.t_max - hit.t);
    return rest;
}

Scene::Scene(const SceneData& data, const V3d& eye_position_world, const ViewFrame& view)
    : data_(data), frame_{.eye_position_world = eye_position_world,
                          .view = view,
                          .direction_view = view,
                          .textures = &data.textures}
{
    for (int axis = 0; axis < 3; ++axis) {
        frame_.direction_view.camera_from_world[3][axis] = 0.0f;
    }
    add_placements();
    add_media();
    accelerator_.build();
    look_around_eye();

    add_lamps();
    environment_ = Environment(data.world, frame_, data.world_sun);
    std::vector<EmissiveTriangle> triangles;
    add_emitters(triangles);
    light_sampler_ =
        LightSampler(lamps_, triangles, is_cut_off_from_infinity() ? Environment() : environment_);
}

std::optional<SurfaceHit> Scene::intersect(const Ray& ray, const PathState& path) const
{
    return nearest(ray, ray_mask(path));
}

std::optional<SurfaceHit> Scene::nearest(const Ray& ray, RayMask mask) const
{
    const auto found = accelerator_.intersect(ray, mask);
    if (!found) {
        return std::nullopt;
    }
    const Placement& placement = placements_[found->placement];
    Room<Pose> moved;
    return make_surface_hit(ray, *found, placement, pose_at(placement, ray.time, moved),
                            accelerator_.positions(found->placement));
}

const Pose& Scene::pose_at(const Placement& placement, float time, Room<Pose>& moved) const
{
    if (!placement.moves) {
        return placement.pose;
    }
    const auto number = static_cast<std::uint32_t>(&placement - placements_.data());
    const M44f world_from_object = accelerator_.world_from_object(number, time);
    return moved.fill({.world_from_object = world_from_object,
                       .world_from_object_normal = normal_matrix(M44d(world_from_object))});
}

V3f Scene::place_at(const SurfaceHit& hit, float time) const
{
    const auto in_object = [&hit](float when) {
        if (const Mesh* const mesh = hit.placement->mesh()) {
            const auto [p0, p1, p2] = mesh->corners(hit.primitive, when);
            return interpolate(p0, p1, p2, hit.u, hit.v);
        }
        if (const auto* const curves = std::get_if<Curves>(hit.placement->geometry)) {
            return strand_point(*curves, strand_place(*curves, hit.primitive, hit.u), when)
                .at.center;
        }
        const auto& points = std::get<Points>(*hit.placement->geometry);
        return at_time(points.points, points.motion, hit.primitive, when).center;
    };
    Room<Pose> moved_now;
    Room<Pose> moved_then;
    const M44f& now = pose_at(*hit.placement, hit.time, moved_now).world_from_object;
    const M44f& then = pose_at(*hit.placement, time, moved_then).world_from_object;
    // From the place itself: what keeps still keeps it exactly.
    return hit.p_world + (in_object(time) * then - in_object(hit.time) * now);
}

ShadedPoint Scene::shade(const SurfaceHit& hit, const PathState& path) const
{
    const SceneProbe probe(*this, hit);
    return look_at(hit, [&](const HitAttributes& at) {
        return hit.material().surface.shade(
            {.point = hit.point, .attributes = at, .path = path, .probe = &probe});
    });
}

Color3f Scene::straight_transmittance(const SurfaceHit& hit, const PathState& path) const
{
    return look_at(hit, [&](const HitAttributes& at) {
        return hit.material().surface.straight_transmittance(
            {.point = hit.point, .attributes = at, .path = path});
    });
}

Color3f Scene::transmittance(const Ray& ray,
                             const PathState& path,
                             int most_passages,
                             MediumStack* media,
                             int blocker_set) const
{
    PathState shadow = path;
    shadow.is_camera = false;
    shadow.is_shadow = true;
    const RayMask mask = ray_mask(shadow, blocker_set);
    if (!may_be_transparent_ && media == nullptr) {
        return Color3f(accelerator_.occluded(ray, mask) ? 0.0f : 1.0f);
    }
    Color3f result(1.0f);
    Ray rest = ray;
    float travelled = 0.0f;
    int boundaries = 0;
    for (int passages = 0; passages <= most_passages && boundaries <= max_boundaries;) {
        const auto hit = nearest(rest, mask);
        if (hit && !hit->material().surface.may_be_transparent()) {
            break;
        }
        if (media != nullptr) {
            if (!hit && !std::isfinite(rest.t_max)) {
                media->leave_meshes();
            }
            if (media->in_medium()) {
                result *= media->mixture().transmittance(hit ? hit->t : rest.t_max);
            }
        }
        if (!hit) {
            return result;
        }
        travelled += hit->t;
        if (hit->material().is_boundary) {
            ++boundaries;
        } else {
            shadow.length = travelled;
            result *= straight_transmittance(*hit, shadow);
            ++shadow.transparent_depth;
            ++passages;
        }
        if (max_component(result) <= 0.0f) {
            break;
        }
        if (media != nullptr) {
            media->cross(*hit);
        }
        rest = passed_through(rest, *hit);
        if (hit->strand.end == 0) {
            rest.left = ray.left;  // the strand that it started from is in no shadow of its own
        }
    }
    return Color3f(0.0f);
}

std::optional<SurfaceHit> Scene::first_visible(const Ray& ray, float least_alpha) const
{
    Ray rest = ray;
    float travelled = 0.0f;
    for (int passages = 0; passages <= max_straight_passages; ++passages) {
        auto hit = intersect(rest);
        if (!hit) {
            break;
        }
        const Material& material = hit->material();
        if (!material.surface.may_be_transparent() ||
            1.0f - luminance(straight_transmittance(*hit, {})) >= least_alpha) {
            hit->t += travelled;
            return hit;
        }
        travelled += hit->t;
        rest = passed_through(rest, *hit);
    }
    return std::nullopt;
}

}  // namespace eye_render
