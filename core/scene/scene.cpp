#include "scene/scene.h"

#include "base/warp.h"

#include <cmath>
#include <stdexcept>

namespace eye_render {

namespace {

// Shadow rays stop this much short of their target, relative to its distance: float positions on
// both ends are good to about 1e-7 of their size, and a lamp may touch a wall.
constexpr float shadow_margin = 1e-4f;

int layer_named(const std::string& name, const auto& layers)
{
    if (name.empty()) {
        return layers.empty() ? LayerLookup::none : 0;
    }
    for (std::size_t i = 0; i < layers.size(); ++i) {
        if (layers[i].name == name) {
            return static_cast<int>(i);
        }
    }
    return LayerLookup::none;
}

LayerLookup find_layers(const SceneData& data, const Mesh& mesh)
{
    LayerLookup lookup;
    for (const std::string& name : data.uv_layer_names) {
        lookup.uv.push_back(layer_named(name, mesh.uv_layers));
    }
    for (const std::string& name : data.color_attribute_names) {
        lookup.color.push_back(layer_named(name, mesh.color_attributes));
    }
    return lookup;
}

M44d relative_to_eye(M44d world_from_object, const V3d& eye_position_world)
{
    for (int axis = 0; axis < 3; ++axis) {
        world_from_object[3][axis] -= eye_position_world[axis];
    }
    return world_from_object;
}

M33f upper_left(const M44d& m)
{
    return {static_cast<float>(m[0][0]), static_cast<float>(m[0][1]), static_cast<float>(m[0][2]),
            static_cast<float>(m[1][0]), static_cast<float>(m[1][1]), static_cast<float>(m[1][2]),
            static_cast<float>(m[2][0]), static_cast<float>(m[2][1]), static_cast<float>(m[2][2])};
}

// Cofactors of the upper-left block, with the sign of its determinant: the inverse transpose times
// a positive factor. Unlike the inverse it exists for a flattened object, too.
M33f normal_matrix(const M44d& m)
{
    const V3d x(m[0][0], m[0][1], m[0][2]);
    const V3d y(m[1][0], m[1][1], m[1][2]);
    const V3d z(m[2][0], m[2][1], m[2][2]);
    const double sign = x.dot(y.cross(z)) < 0.0 ? -1.0 : 1.0;
    const V3d row[3] = {y.cross(z) * sign, z.cross(x) * sign, x.cross(y) * sign};
    // Scaled to its largest entry, so that objects in micrometres do not underflow in float.
    double largest = 0.0;
    for (const V3d& r : row) {
        largest = std::max({largest, std::abs(r.x), std::abs(r.y), std::abs(r.z)});
    }
    const double scale = largest > 0.0 ? 1.0 / largest : 1.0;
    M44d scaled;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            scaled[i][j] = row[i][j] * scale;
        }
    }
    return upper_left(scaled);
}

M44f to_float(const M44d& m)
{
    M44f result;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            result[i][j] = static_cast<float>(m[i][j]);
        }
    }
    return result;
}

}  // namespace

Scene::Scene(const SceneData& data, const V3d& eye_position_world) : data_(data)
{
    add_placements(eye_position_world);
    accelerator_.build();

    for (const LampData& lamp : data.lamps) {
        LampSettings settings = lamp.settings;
        settings.world_from_light =
            to_float(relative_to_eye(lamp.world_from_light, eye_position_world));
        lamps_.push_back(make_lamp(settings));
        if (!lamps_.back().is_delta) {
            visible_lamps_.push_back(static_cast<std::uint32_t>(lamps_.size() - 1));
        }
    }
    environment_ = Environment(data.world, &data.textures);
    std::vector<EmissiveTriangle> triangles;
    add_emitters(triangles);
    light_sampler_ = LightSampler(lamps_, triangles, environment_);
}

void Scene::add_placements(const V3d& eye_position_world)
{
    std::vector<std::size_t> uses(data_.meshes.size(), 0);
    for (const InstanceData& instance : data_.instances) {
        ++uses[instance.mesh];
    }
    for (const Mesh& mesh : data_.meshes) {
        mesh_layers_.push_back(find_layers(data_, mesh));
    }
    std::vector<std::optional<Accelerator::Prototype>> prototypes(data_.meshes.size());
    placements_.reserve(data_.instances.size());
    std::vector<V3f> flat_positions;
    for (const InstanceData& instance : data_.instances) {
        const Mesh& mesh = data_.meshes[instance.mesh];
        if (mesh.triangles.empty()) {
            continue;
        }
        const M44d world_from_object =
            relative_to_eye(instance.world_from_object, eye_position_world);
        Placement placement{.mesh = &mesh,
                            .layers = &mesh_layers_[instance.mesh],
                            .materials = {},
                            .world_from_object = to_float(world_from_object),
                            .world_from_object_normal = normal_matrix(world_from_object),
                            .is_flat = uses[instance.mesh] == 1,
                            .is_mirrored = upper_left(world_from_object).determinant() < 0.0f,
                            .emitters = {}};
        for (const std::size_t material : instance.materials) {
            placement.materials.push_back(&data_.materials[material]);
        }
        if (placement.materials.empty()) {
            placement.materials.push_back(&plain_material_);
        }
        for (const Material* material : placement.materials) {
            may_be_transparent_ = may_be_transparent_ || material->may_be_transparent();
        }
        if (placement.is_flat) {
            flat_positions.resize(mesh.positions.size());
            for (std::size_t i = 0; i < flat_positions.size(); ++i) {
                // In double, so that an object far from its own origin but near the eye is exact.
                flat_positions[i] = V3f(V3d(mesh.positions[i]) * world_from_object);
            }
            accelerator_.add_flat(flat_positions, mesh.triangles);
        }
        else {
            auto& prototype = prototypes[instance.mesh];
            if (!prototype) {
                prototype = accelerator_.add_prototype(mesh.positions, mesh.triangles);
            }
            accelerator_.place(*prototype, placement.world_from_object);
        }
        triangle_count_ += mesh.triangles.size();
        placements_.push_back(std::move(placement));
    }
}

void Scene::add_emitters(std::vector<EmissiveTriangle>& triangles)
{
    for (Placement& placement : placements_) {
        const Mesh& mesh = *placement.mesh;
        const bool may_emit = std::ranges::any_of(
            placement.materials, [](const Material* material) { return material->may_emit(); });
        if (!may_emit) {
            continue;
        }
        placement.emitters.assign(mesh.triangles.size(), -1);
        for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
            const Material& material = placement.material(t);
            if (!material.may_emit()) {
                continue;
            }
            // A textured emitter is judged by its centre and its corners' neighbourhoods.
            constexpr std::array<V2f, 4> probes{
                V2f{1.0f / 3, 1.0f / 3}, {0.1f, 0.1f}, {0.8f, 0.1f}, {0.1f, 0.8f}};
            float estimate = 0.0f;
            for (const V2f& b : probes) {
                const MeshAttributes attributes(placement, t, b.x, b.y, data_.textures);
                estimate += luminance(emitted_radiance(material, attributes)) / probes.size();
            }
            const Emitter emitter{.placement = &placement, .triangle = t};
            const auto [p0, p1, p2] = corners_world(emitter);
            placement.emitters[t] = static_cast<int>(emitters_.size());
            emitters_.push_back(emitter);
            triangles.push_back({.p0_world = p0, .p1_world = p1, .p2_world = p2, .radiance = estimate});
        }
    }
}

std::array<V3f, 3> Scene::corners_world(const Emitter& emitter) const
{
    const auto number = static_cast<std::uint32_t>(emitter.placement - placements_.data());
    const std::span<const V3f> positions = accelerator_.positions(number);
    std::array<V3f, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
        const V3f& p = positions[emitter.placement->mesh->triangles[emitter.triangle][i]];
        corners[i] = emitter.placement->is_flat ? p : p * emitter.placement->world_from_object;
    }
    return corners;
}

std::optional<SurfaceHit> Scene::intersect(const Ray& ray) const
{
    const auto found = accelerator_.intersect(ray);
    if (!found) {
        return std::nullopt;
    }
    return make_surface_hit(
        ray, *found, placements_[found->placement], accelerator_.positions(found->placement));
}

Color3f Scene::transmittance(const Ray& ray) const
{
    if (!may_be_transparent_) {
        return Color3f(accelerator_.occluded(ray) ? 0.0f : 1.0f);
    }
    Color3f result(1.0f);
    Ray rest = ray;
    while (const auto hit = intersect(rest)) {
        const Material& material = hit->material();
        if (!material.may_be_transparent()) {
            return Color3f(0.0f);
        }
        result *= straight_transmittance(material, attributes(*hit));
        if (max_component(result) <= 0.0f) {
            return Color3f(0.0f);
        }
        rest.origin = offset_from_surface(hit->p_world, -hit->point.ng);
        // The end stays where it was; an infinite one does, too.
        rest.t_max -= hit->t;
        if (!(rest.t_max > 0.0f)) {
            break;
        }
    }
    return result;
}

std::optional<IncomingLight> Scene::sample_light(const V3f& p,
                                                 const V3f& n,
                                                 float u_light,
                                                 const V2f& u) const
{
    const auto choice = light_sampler_.choose(p, n, u_light);
    if (!choice) {
        return std::nullopt;
    }
    std::optional<IncomingLight> light;
    switch (choice->kind) {
    case LightKind::Lamp: {
        const Lamp& lamp = lamps_[choice->index];
        if (const auto sample = sample_lamp(lamp, p, u)) {
            light = IncomingLight{.wi = sample->wi,
                                  .distance = sample->distance * (1.0f - shadow_margin),
                                  .radiance = sample->radiance,
                                  .pdf = sample->pdf,
                                  .is_delta = sample->is_delta,
                                  .casts_shadow = lamp.casts_shadow};
        }
        break;
    }
    case LightKind::Triangle: light = sample_emitter(choice->index, p, u); break;
    case LightKind::Environment: {
        const EnvironmentSample sample = environment_.sample(u);
        light = IncomingLight{.wi = sample.wi,
                              .distance = std::numeric_limits<float>::infinity(),
                              .radiance = sample.radiance,
                              .pdf = sample.pdf};
        break;
    }
    }
    if (!light || !(light->pdf > 0.0f)) {
        return std::nullopt;
    }
    light->pdf *= choice->probability;
    return light;
}

std::optional<IncomingLight> Scene::sample_emitter(std::uint32_t index,
                                                   const V3f& p,
                                                   const V2f& u) const
{
    const Emitter& emitter = emitters_[index];
    const auto [p0, p1, p2] = corners_world(emitter);
    const V2f b = sample_uniform_triangle(u);  // weights of p0 and p1
    const V3f to_light = p0 * b.x + p1 * b.y + p2 * (1.0f - b.x - b.y) - p;
    const float distance2 = to_light.length2();
    const float distance = std::sqrt(distance2);
    // |2 area normal . to_light|; zero when seen edge-on or from its own plane.
    const float projected = std::abs((p1 - p0).cross(p2 - p0).dot(to_light));
    if (!(projected > 0.0f)) {
        return std::nullopt;
    }
    const MeshAttributes attributes(
        *emitter.placement, emitter.triangle, b.y, 1.0f - b.x - b.y, data_.textures);
    return IncomingLight{
        .wi = to_light / distance,
        .distance = distance * (1.0f - shadow_margin),
        .radiance = emitted_radiance(emitter.placement->material(emitter.triangle), attributes),
        .pdf = uniform_triangle_pdf() * distance2 * distance / projected};
}

float Scene::emitter_pdf(const SurfaceHit& hit, const V3f& p, const V3f& n) const
{
    const int emitter = hit.emitter();
    if (emitter < 0) {
        return 0.0f;
    }
    const auto index = static_cast<std::uint32_t>(emitter);
    const auto [p0, p1, p2] = corners_world(emitters_[index]);
    const V3f to_light = hit.p_world - p;
    const float distance2 = to_light.length2();
    const float projected = std::abs((p1 - p0).cross(p2 - p0).dot(to_light));
    if (!(projected > 0.0f)) {
        return 0.0f;
    }
    return uniform_triangle_pdf() * distance2 * std::sqrt(distance2) / projected *
           light_sampler_.probability(LightKind::Triangle, index, p, n);
}

float Scene::environment_pdf(const V3f& wi, const V3f& p, const V3f& n) const
{
    return environment_.pdf(wi) * light_sampler_.probability(LightKind::Environment, 0, p, n);
}

}  // namespace eye_render
