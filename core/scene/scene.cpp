#include "scene/scene.h"

#include "scene/scene_probe.h"
#include "scene/transform.h"

#include <algorithm>

namespace eye_render {

namespace {

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
    for (const std::string& name : data.attribute_names) {
        lookup.attributes.push_back(layer_named(name, mesh.attributes));
    }
    return lookup;
}

}  // namespace

Ray passed_through(const Ray& ray, const SurfaceHit& hit)
{
    return {.origin = hit.origin_towards(ray.direction),
            .direction = ray.direction,
            .t_max = std::max(0.0f, ray.t_max - hit.t)};
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
    accelerator_.build();

    add_lamps();
    environment_ = Environment(data.world, frame_, data.world_sun);
    std::vector<EmissiveTriangle> triangles;
    add_emitters(triangles);
    light_sampler_ = LightSampler(lamps_, triangles, environment_);
}

void Scene::add_placements()
{
    std::vector<std::size_t> uses(data_.meshes.size(), 0);
    for (const InstanceData& instance : data_.instances) {
        ++uses[instance.mesh];
    }
    for (const Mesh& mesh : data_.meshes) {
        mesh_layers_.push_back(find_layers(data_, mesh));
        texture_spaces_.push_back(mesh.texture_space ? *mesh.texture_space
                                                     : texture_space_of(mesh));
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
            relative_to_eye(instance.world_from_object, frame_.eye_position_world);
        Placement placement{.mesh = &mesh,
                            .layers = &mesh_layers_[instance.mesh],
                            .texture_space = &texture_spaces_[instance.mesh],
                            .materials = {},
                            .world_from_object = to_float(world_from_object),
                            .world_from_object_normal = normal_matrix(world_from_object),
                            .is_flat =
                                uses[instance.mesh] == 1 || !is_invertible(world_from_object),
                            .is_mirrored = is_mirror(world_from_object),
                            .look = instance.look,
                            .visibility = instance.visibility,
                            .is_holdout = instance.is_holdout,
                            .is_shadow_catcher = instance.is_shadow_catcher,
                            .matte = instance.matte,
                            .light_group = instance.light_group,
                            .emitters = {}};
        for (const std::size_t material : instance.materials) {
            placement.materials.push_back(&data_.materials[material]);
        }
        if (placement.materials.empty()) {
            placement.materials.push_back(&grey_);
        }
        for (const Material* material : placement.materials) {
            may_be_transparent_ = may_be_transparent_ || material->surface.may_be_transparent();
        }
        has_hidden_ = has_hidden_ || instance.is_shadow_catcher || !instance.visibility.to_all();
        may_be_transparent_ =
            may_be_transparent_ || instance.is_shadow_catcher || !instance.visibility.to_shadow;
        if (placement.is_flat) {
            flat_positions.resize(mesh.positions.size());
            for (std::size_t i = 0; i < flat_positions.size(); ++i) {
                // In double, so that an object far from its own origin but near the eye is exact.
                flat_positions[i] = V3f(V3d(mesh.positions[i]) * world_from_object);
            }
            accelerator_.add_flat(flat_positions, mesh.triangles);
        } else {
            auto& prototype = prototypes[instance.mesh];
            if (!prototype) {
                prototype = accelerator_.add_prototype(mesh.positions, mesh.triangles);
            }
            accelerator_.place(*prototype, placement.world_from_object);
        }
        placements_.push_back(std::move(placement));
    }
}

std::optional<SurfaceHit> Scene::intersect(const Ray& ray, const PathState& path) const
{
    Ray rest = ray;
    float travelled = 0.0f;
    for (int passages = 0; passages <= max_straight_passages; ++passages) {
        const auto found = accelerator_.intersect(rest);
        if (!found) {
            break;
        }
        const Placement& placement = placements_[found->placement];
        SurfaceHit hit =
            make_surface_hit(rest, *found, placement, accelerator_.positions(found->placement));
        const bool is_there = !path.sees_catchers_only || placement.is_shadow_catcher;
        if (!has_hidden_ || (is_there && placement.visibility.sees(path))) {
            hit.t += travelled;
            return hit;
        }
        travelled += hit.t;
        rest = passed_through(rest, hit);
    }
    return std::nullopt;
}

ShadedPoint Scene::shade(const SurfaceHit& hit, const PathState& path) const
{
    const MeshAttributes at = attributes(hit);
    const SceneProbe probe(*this, hit);
    return hit.material().surface.shade(
        {.point = hit.point, .attributes = at, .path = path, .probe = &probe});
}

Color3f Scene::straight_transmittance(const SurfaceHit& hit, const PathState& path) const
{
    const MeshAttributes at = attributes(hit);
    return hit.material().surface.straight_transmittance(
        {.point = hit.point, .attributes = at, .path = path});
}

Color3f Scene::transmittance(const Ray& ray, const PathState& path, int most_passages) const
{
    if (!may_be_transparent_) {
        return Color3f(accelerator_.occluded(ray) ? 0.0f : 1.0f);
    }
    Color3f result(1.0f);
    PathState shadow = path;
    shadow.is_camera = false;
    shadow.is_shadow = true;
    Ray rest = ray;
    for (int passages = 0; passages <= most_passages; ++passages) {
        const auto hit = intersect(rest, shadow);
        if (!hit) {
            return result;
        }
        const Material& material = hit->material();
        if (!material.surface.may_be_transparent()) {
            break;
        }
        shadow.length = hit->t;
        result *= straight_transmittance(*hit, shadow);
        ++shadow.transparent_depth;
        if (max_component(result) <= 0.0f) {
            break;
        }
        rest = passed_through(rest, *hit);
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
