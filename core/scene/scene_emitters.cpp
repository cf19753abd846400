// The meshes of a scene that shine, triangle by triangle: light sampling and its density.

#include "base/magnitude.h"
#include "scene/barycentric.h"
#include "scene/light_path.h"
#include "scene/mesh_attributes.h"
#include "scene/scene.h"
#include "scene/triangle_light.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// At which the reach of what moves is looked at; between them it is hardly farther.
constexpr std::array<float, 5> looks{0.0f, 0.25f, shutter_middle, 0.75f, 1.0f};

[[nodiscard]] bool may_emit(const Placement& placement)
{
    return std::ranges::any_of(placement.materials, [](const Material* material) {
        return material->surface.may_emit();
    });
}

}  // namespace

void Scene::add_emitters(std::vector<EmissiveTriangle>& triangles)
{
    for (Placement& placement : placements_) {
        const Mesh* const mesh = placement.mesh();
        // Strands and balls are found by the rays of BSDFs alone.
        if (mesh == nullptr || !may_emit(placement)) {
            continue;
        }
        const bool is_still = !placement.moves && mesh->motion_positions.empty();
        placement.emitters.assign(mesh->triangles.size(), -1);
        for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) {
            if (!placement.material(t).surface.may_emit()) {
                continue;
            }
            const Emitter emitter{.placement = &placement, .triangle = t};
            const auto [p0, p1, p2] = corners_world(emitter, shutter_middle);
            EmissiveTriangle triangle{.p0_world = p0,
                                      .p1_world = p1,
                                      .p2_world = p2,
                                      .radiance = mean_emission(emitter)};
            if (!is_still) {
                for (const float time : looks) {
                    for (const V3f& corner : corners_world(emitter, time)) {
                        triangle.reach.extendBy(corner);
                    }
                }
            }
            placement.emitters[t] = static_cast<int>(emitters_.size());
            emitters_.push_back(emitter);
            triangles.push_back(triangle);
        }
    }
}

// Luminance. A textured emitter is judged by its centre and its corners' neighbourhoods, towards
// its own two sides: a material may shine on one of them alone.
float Scene::mean_emission(const Emitter& emitter) const
{
    constexpr std::array<V2f, 4> probes{
        V2f{1.0f / 3, 1.0f / 3}, {0.1f, 0.1f}, {0.8f, 0.1f}, {0.1f, 0.8f}};
    const V3f normal = emitter_normal(emitter, shutter_middle);
    float mean = 0.0f;
    for (const V2f& weights : probes) {
        for (const float side : {1.0f, -1.0f}) {
            mean +=
                luminance(magnitude(emission(emitter, weights, normal * side, shutter_middle))) /
                (2.0f * probes.size());
        }
    }
    return mean;
}

V3f Scene::emitter_normal(const Emitter& emitter, float time) const
{
    const auto [p0, p1, p2] = corners_world(emitter, time);
    const V3f normal = unit_or((p1 - p0).cross(p2 - p0), V3f(0.0f, 0.0f, 1.0f));
    return emitter.placement->is_mirrored ? -normal : normal;
}

Color3f Scene::emission(const Emitter& emitter,
                        const V2f& weights,
                        const V3f& wo,
                        float time) const
{
    const V3f normal = emitter_normal(emitter, time);
    const bool backfacing = normal.dot(wo) < 0.0f;
    Room<Pose> moved;
    const MeshAttributes at(*emitter.placement, pose_at(*emitter.placement, time, moved),
                            emitter.triangle, weights.x, weights.y, time, frame_);
    const V3f ng = backfacing ? -normal : normal;
    const V3f ns = at.smooth_normal() * (backfacing ? -1.0f : 1.0f);
    const ShadingPoint point{.wo = wo, .ng = ng, .ns = ns, .backfacing = backfacing};
    return emitter.placement->material(emitter.triangle)
        .surface.emission({.point = point, .attributes = at, .path = light_path});
}

std::array<V3f, 3> Scene::accelerator_corners(const Emitter& emitter, float time) const
{
    const auto number = static_cast<std::uint32_t>(emitter.placement - placements_.data());
    const MotionSteps<V3f>& positions = accelerator_.positions(number);
    const TriangleIndices& corner = emitter.placement->mesh()->triangles[emitter.triangle];
    return {positions.at(corner[0], time), positions.at(corner[1], time),
            positions.at(corner[2], time)};
}

std::array<V3f, 3> Scene::corners_world(const Emitter& emitter, float time) const
{
    std::array<V3f, 3> corners = accelerator_corners(emitter, time);
    if (!emitter.placement->is_flat) {
        Room<Pose> moved;
        const Pose& pose = pose_at(*emitter.placement, time, moved);
        for (V3f& p : corners) {
            p = p * pose.world_from_object;
        }
    }
    return corners;
}

std::optional<IncomingLight> Scene::sample_emitter(std::uint32_t index,
                                                   const LitPoint& point,
                                                   const V2f& u) const
{
    const Emitter& emitter = emitters_[index];
    const V3f& p = point.p_world;
    const std::array<V3f, 3> corners = corners_world(emitter, point.time);
    const TriangleLight seen(corners, p);
    const V2f weights = seen.sample(u);
    const auto& [p0, p1, p2] = corners;
    const V3f on_light = interpolate(p0, p1, p2, weights.x, weights.y);
    const V3f normal = (p1 - p0).cross(p2 - p0).normalized();
    // The shadow ray ends before the emitter's own surface.
    const V3f target = offset_from_surface(
        on_light, normal.dot(p - on_light) < 0.0f ? -normal : normal,
        position_error(*emitter.placement, accelerator_corners(emitter, point.time)));
    const V3f to_light = target - p;
    const float pdf = seen.pdf(to_light);
    if (!(pdf > 0.0f)) {
        return std::nullopt;
    }
    const float distance = to_light.length();
    return IncomingLight{.wi = to_light / distance,
                         .distance = distance * (1.0f - shadow_margin),
                         .radiance = emission(emitter, weights, -to_light / distance, point.time),
                         .pdf = pdf,
                         .is_met_by_rays = emitter.placement->links.blocker_set == 0,
                         .visibility = emitter.placement->visibility,
                         .is_surface = true,
                         .is_of_catcher = emitter.placement->is_shadow_catcher,
                         .links = emitter.placement->links,
                         .origin = {.group = emitter.placement->light_group}};
}

float Scene::emitter_pdf(const SurfaceHit& hit, const LitPoint& point) const
{
    if (hit.emitter() < 0) {
        return 0.0f;
    }
    const auto index = static_cast<std::uint32_t>(hit.emitter());
    const TriangleLight seen(corners_world(emitters_[index], hit.time), point.p_world);
    return seen.pdf(hit.p_world - point.p_world) *
           light_sampler_.probability(LightKind::Triangle, index, point);
}

}  // namespace eye_render
