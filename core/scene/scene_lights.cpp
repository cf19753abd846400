// The lights of a scene: which triangles shine, and light sampling with its densities.

#include "base/magnitude.h"
#include "base/warp.h"
#include "scene/light_path.h"
#include "scene/mesh_attributes.h"
#include "scene/scene.h"

#include <cmath>

namespace eye_render {

namespace {

// Shadow rays stop this much short of a lamp or emitter, relative to its distance: 32 float steps,
// 0.1 mm at 30 m, for the roundings of distance and direction.
constexpr float shadow_margin = 4e-6f;

}  // namespace

void Scene::add_emitters(std::vector<EmissiveTriangle>& triangles)
{
    for (Placement& placement : placements_) {
        const Mesh* const mesh = placement.mesh();
        // Strands and balls, and what moves or deforms, are found by the rays of BSDFs alone.
        if (mesh == nullptr || placement.moves || !mesh->motion_positions.empty()) {
            continue;
        }
        const bool may_emit =
            std::ranges::any_of(placement.materials, [](const Material* material) {
                return material->surface.may_emit();
            });
        if (!may_emit) {
            continue;
        }
        placement.emitters.assign(mesh->triangles.size(), -1);
        for (std::uint32_t t = 0; t < mesh->triangles.size(); ++t) {
            const Material& material = placement.material(t);
            if (!material.surface.may_emit()) {
                continue;
            }
            // A textured emitter is judged by its centre and its corners' neighbourhoods.
            constexpr std::array<V2f, 4> probes{
                V2f{1.0f / 3, 1.0f / 3}, {0.1f, 0.1f}, {0.8f, 0.1f}, {0.1f, 0.8f}};
            const Emitter emitter{.placement = &placement, .triangle = t};
            // Towards its own two sides: a material may shine on one of them alone.
            float estimate = 0.0f;
            const V3f normal = emitter_normal(emitter);
            for (const V2f& weights : probes) {
                for (const float side : {1.0f, -1.0f}) {
                    estimate += luminance(magnitude(emission(emitter, weights, normal * side))) /
                                (2.0f * probes.size());
                }
            }
            const auto [p0, p1, p2] = corners_world(emitter);
            placement.emitters[t] = static_cast<int>(emitters_.size());
            emitters_.push_back(emitter);
            triangles.push_back(
                {.p0_world = p0, .p1_world = p1, .p2_world = p2, .radiance = estimate});
        }
    }
}

V3f Scene::emitter_normal(const Emitter& emitter) const
{
    const auto [p0, p1, p2] = corners_world(emitter);
    const V3f normal = unit_or((p1 - p0).cross(p2 - p0), V3f(0.0f, 0.0f, 1.0f));
    return emitter.placement->is_mirrored ? -normal : normal;
}

Color3f Scene::emission(const Emitter& emitter, const V2f& weights, const V3f& wo) const
{
    const V3f normal = emitter_normal(emitter);
    const bool backfacing = normal.dot(wo) < 0.0f;
    const MeshAttributes at(*emitter.placement, emitter.placement->pose, emitter.triangle,
                            weights.x, weights.y, shutter_middle, frame_);
    const V3f ng = backfacing ? -normal : normal;
    const V3f ns = at.smooth_normal() * (backfacing ? -1.0f : 1.0f);
    const ShadingPoint point{.wo = wo, .ng = ng, .ns = ns, .backfacing = backfacing};
    return emitter.placement->material(emitter.triangle)
        .surface.emission({.point = point, .attributes = at, .path = light_path});
}

std::array<V3f, 3> Scene::accelerator_corners(const Emitter& emitter) const
{
    const auto number = static_cast<std::uint32_t>(emitter.placement - placements_.data());
    const MotionSteps<V3f>& positions = accelerator_.positions(number);
    const TriangleIndices& corner = emitter.placement->mesh()->triangles[emitter.triangle];
    return {positions.at(corner[0], shutter_middle), positions.at(corner[1], shutter_middle),
            positions.at(corner[2], shutter_middle)};
}

std::array<V3f, 3> Scene::corners_world(const Emitter& emitter) const
{
    std::array<V3f, 3> corners = accelerator_corners(emitter);
    if (!emitter.placement->is_flat) {
        for (V3f& p : corners) {
            p = p * emitter.placement->pose.world_from_object;
        }
    }
    return corners;
}

std::optional<IncomingLight> Scene::sample_light(const LitPoint& point,
                                                 double u_light,
                                                 const V2f& u) const
{
    const V3f& p = point.p_world;
    const auto choice = light_sampler_.choose(point, u_light);
    if (!choice) {
        return std::nullopt;
    }
    std::optional<IncomingLight> light;
    switch (choice->kind) {
    case LightKind::Lamp: {
        const Lamp& lamp = lamps_[choice->index];
        const LightLinks& links = data_.lamps[choice->index].links;
        if (const auto sample = sample_lamp(lamp, p, u)) {
            const LampSight sight{
                .p_lit_world = p, .wi = sample->wi, .distance = sample->distance};
            light = IncomingLight{
                .wi = sample->wi,
                .distance = sample->distance * (1.0f - shadow_margin),
                .radiance = sample->radiance * lamp_factor(choice->index, sight, light_path),
                .pdf = sample->pdf,
                .is_met_by_rays = !lamp.is_delta && lamp.casts_shadow && links.blocker_set == 0,
                .casts_shadow = lamp.casts_shadow,
                .visibility = lamp.visibility,
                .links = links,
                .origin = {.group = data_.lamps[choice->index].light_group}};
        }
        break;
    }
    case LightKind::Triangle: light = sample_emitter(choice->index, p, u); break;
    case LightKind::Environment: {
        const EnvironmentSample sample = environment_.sample(u);
        light = IncomingLight{.wi = sample.wi,
                              .distance = std::numeric_limits<float>::infinity(),
                              .radiance = sample.radiance,
                              .pdf = sample.pdf,
                              .visibility = data_.world_visibility,
                              .origin = world_origin()};
        break;
    }
    }
    if (!light || !(light->pdf > 0.0f)) {
        return std::nullopt;
    }
    light->pdf *= choice->probability;
    return light;
}

std::optional<V3f> Scene::light_center(const LitPoint& point, double u_light) const
{
    const auto choice = light_sampler_.choose(point, u_light);
    if (!choice || choice->kind == LightKind::Environment) {
        return std::nullopt;
    }
    if (choice->kind == LightKind::Triangle) {
        const auto [p0, p1, p2] = corners_world(emitters_[choice->index]);
        return (p0 + p1 + p2) / 3.0f;
    }
    const Lamp& lamp = lamps_[choice->index];
    return lamp.kind == LampKind::Sun ? std::nullopt : std::optional(lamp.position);
}

std::optional<IncomingLight> Scene::sample_emitter(std::uint32_t index,
                                                   const V3f& p,
                                                   const V2f& u) const
{
    const Emitter& emitter = emitters_[index];
    const auto [p0, p1, p2] = corners_world(emitter);
    const V2f b = sample_uniform_triangle(u);  // weights of p0 and p1
    const V3f on_light = p0 * b.x + p1 * b.y + p2 * (1.0f - b.x - b.y);
    const V3f normal = (p1 - p0).cross(p2 - p0).normalized();
    // The shadow ray ends before the emitter's own surface.
    const V3f target =
        offset_from_surface(on_light, normal.dot(p - on_light) < 0.0f ? -normal : normal,
                            position_error(*emitter.placement, accelerator_corners(emitter)));
    const V3f to_light = target - p;
    const float distance2 = to_light.length2();
    const float distance = std::sqrt(distance2);
    // |2 area normal . to_light|; zero when seen edge-on or from its own plane.
    const float projected = std::abs((p1 - p0).cross(p2 - p0).dot(to_light));
    if (!(projected > 0.0f)) {
        return std::nullopt;
    }
    return IncomingLight{.wi = to_light / distance,
                         .distance = distance * (1.0f - shadow_margin),
                         .radiance =
                             emission(emitter, {b.y, 1.0f - b.x - b.y}, -to_light / distance),
                         .pdf = uniform_triangle_pdf() * distance2 * distance / projected,
                         .is_met_by_rays = emitter.placement->links.blocker_set == 0,
                         .visibility = emitter.placement->visibility,
                         .is_surface = true,
                         .is_of_catcher = emitter.placement->is_shadow_catcher,
                         .links = emitter.placement->links,
                         .origin = {.group = emitter.placement->light_group}};
}

float Scene::emitter_pdf(const SurfaceHit& hit, const LitPoint& point) const
{
    const int emitter = hit.emitter();
    if (emitter < 0) {
        return 0.0f;
    }
    const auto index = static_cast<std::uint32_t>(emitter);
    const auto [p0, p1, p2] = corners_world(emitters_[index]);
    const V3f to_light = hit.p_world - point.p_world;
    const float distance2 = to_light.length2();
    const float projected = std::abs((p1 - p0).cross(p2 - p0).dot(to_light));
    if (!(projected > 0.0f)) {
        return 0.0f;
    }
    return uniform_triangle_pdf() * distance2 * std::sqrt(distance2) / projected *
           light_sampler_.probability(LightKind::Triangle, index, point);
}

float Scene::environment_pdf(const V3f& wi, const LitPoint& point) const
{
    return environment_.pdf(wi) * light_sampler_.probability(LightKind::Environment, 0, point);
}

}  // namespace eye_render
