// The objects of a scene: what is placed once goes to the accelerator as it stands in the world,
// what occurs more than once or moves as a prototype.

#include "scene/scene.h"
#include "scene/transform.h"

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

// Points have no UV maps, nor has anything else than meshes and strands.
LayerLookup find_layers(const SceneData& data, const Geometry& geometry)
{
    LayerLookup lookup;
    for (const std::string& name : data.uv_layer_names) {
        lookup.uv.push_back(std::visit(
            [&](const auto& any) {
                if constexpr (requires { any.uv_layers; }) {
                    return layer_named(name, any.uv_layers);
                } else {
                    return LayerLookup::none;
                }
            },
            geometry));
    }
    for (const std::string& name : data.attribute_names) {
        lookup.attributes.push_back(std::visit(
            [&](const auto& any) { return layer_named(name, any.attributes); }, geometry));
    }
    return lookup;
}

// All steps of a geometry's motion, or the one that is there.
template <typename T>
MotionSteps<T> steps_of(const std::vector<T>& values, const std::vector<std::vector<T>>& moving)
{
    MotionSteps<T> all;
    for (const std::vector<T>& step : moving) {
        all.steps.emplace_back(step);
    }
    if (moving.empty()) {
        all.steps.emplace_back(values);
    }
    return all;
}

Shape shape_of(const Mesh& mesh)
{
    return TriangleShape{mesh.triangles, steps_of(mesh.positions, mesh.motion_positions)};
}
Shape shape_of(const Curves& curves)
{
    return StrandsShape{curves.shape, curves.first_keys, steps_of(curves.keys, curves.motion)};
}
Shape shape_of(const Points& points) { return BallsShape{steps_of(points.points, points.motion)}; }

// A geometry's shape in the world, for as long as it takes to hand it over. Positions are moved
// in double, so that an object far from its own origin but near the eye is exact.
class WorldShape {
public:
    WorldShape(const Geometry& geometry, const M44d& world_from_object)
        : shape_(std::visit([](const auto& any) { return shape_of(any); }, geometry)),
          world_from_object_(world_from_object), scale_(scale_of(to_float(world_from_object)))
    {
        if (auto* triangles = std::get_if<TriangleShape>(&shape_)) {
            place(triangles->positions, positions_);
        } else if (auto* strands = std::get_if<StrandsShape>(&shape_)) {
            place(strands->keys, points_);
        } else {
            place(std::get<BallsShape>(shape_).balls, points_);
        }
    }

    [[nodiscard]] const Shape& get() const { return shape_; }

private:
    template <typename T>
    void place(MotionSteps<T>& steps, std::vector<std::vector<T>>& in_world)
    {
        for (std::span<const T>& step : steps.steps) {
            std::vector<T>& placed = in_world.emplace_back();
            placed.reserve(step.size());
            for (const T& item : step) {
                placed.push_back(in_the_world(item));
            }
        }
        for (std::size_t i = 0; i < in_world.size(); ++i) {
            steps.steps[i] = in_world[i];
        }
    }

    [[nodiscard]] V3f in_the_world(const V3f& p) const { return {V3d(p) * world_from_object_}; }
    [[nodiscard]] SizedPoint in_the_world(const SizedPoint& point) const
    {
        return {in_the_world(point.center), point.radius * scale_};
    }

    Shape shape_;
    M44d world_from_object_;
    float scale_;
    std::vector<std::vector<V3f>> positions_;
    std::vector<std::vector<SizedPoint>> points_;
};

}  // namespace

void Scene::add_placements()
{
    const std::vector<Geometry>& geometries = data_.geometries;
    std::vector<std::size_t> uses(geometries.size(), 0);
    for (const InstanceData& instance : data_.instances) {
        ++uses[instance.geometry];
    }
    for (const Geometry& geometry : geometries) {
        geometry_layers_.push_back(find_layers(data_, geometry));
        texture_spaces_.push_back(texture_space_of(geometry));
    }
    std::vector<std::optional<Accelerator::Prototype>> prototypes(geometries.size());
    placements_.reserve(data_.instances.size());
    for (const InstanceData& instance : data_.instances) {
        const Geometry& geometry = geometries[instance.geometry];
        if (is_empty(geometry)) {
            continue;
        }
        const M44d world_from_object =
            relative_to_eye(instance.world_from_object, frame_.eye_position_world);
        // What is flattened cannot be gone back through, and so keeps still.
        const bool moves =
            !instance.motion.empty() && std::ranges::all_of(instance.motion, is_invertible);
        const bool is_flat =
            !moves && (uses[instance.geometry] == 1 || !is_invertible(world_from_object));
        placements_.push_back(
            {.geometry = &geometry,
             .layers = &geometry_layers_[instance.geometry],
             .texture_space = &texture_spaces_[instance.geometry],
             .materials = materials_of(instance),
             .pose = {.world_from_object = to_float(world_from_object),
                      .world_from_object_normal = normal_matrix(world_from_object)},
             .is_flat = is_flat,
             .is_mirrored = is_mirror(world_from_object),
             .moves = moves,
             .look = instance.look,
             .visibility = instance.visibility,
             .is_holdout = instance.is_holdout,
             .is_shadow_catcher = instance.is_shadow_catcher,
             .terminator_cosine = instance.terminator_cosine,
             .matte = instance.matte,
             .light_group = instance.light_group,
             .links = instance.links,
             .light_class = instance.linked.light_class,
             .emitters = {}});
        for (const Material* material : placements_.back().materials) {
            may_be_transparent_ = may_be_transparent_ || material->surface.may_be_transparent();
        }
        const RayMask mask =
            met_by(instance.visibility, instance.is_shadow_catcher, instance.linked);
        if (is_flat) {
            accelerator_.add_flat(WorldShape(geometry, world_from_object).get(), mask);
            continue;
        }
        auto& prototype = prototypes[instance.geometry];
        if (!prototype) {
            prototype = accelerator_.add_prototype(
                std::visit([](const auto& any) { return shape_of(any); }, geometry));
        }
        std::vector<M44d> places{world_from_object};
        if (moves) {
            places.clear();
            for (const M44d& place : instance.motion) {
                places.push_back(relative_to_eye(place, frame_.eye_position_world));
            }
        }
        accelerator_.place(*prototype, places, mask);
    }
}

std::vector<const Material*> Scene::materials_of(const InstanceData& instance) const
{
    std::vector<const Material*> materials;
    for (const std::size_t material : instance.materials) {
        materials.push_back(&data_.materials[material]);
    }
    if (materials.empty()) {
        materials.push_back(&grey_);
    }
    return materials;
}

}  // namespace eye_render
