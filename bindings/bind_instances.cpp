// eyecore.Scene: where geometry stands, and what it wears there.

#include "bind_scene.h"

#include <map>
#include <optional>

namespace eye_render {

namespace {

// Matrices (n, steps, 4, 4), of which those of instance `i` are read.
std::vector<M44d> motion_of(const Array<double>& motion, py::ssize_t i)
{
    std::vector<M44d> places;
    for (py::ssize_t step = 0; step < motion.shape(1); ++step) {
        places.push_back(matrix_from(motion.data(i, step, 0, 0)));
    }
    return places;
}

void add_instances(SceneBuilder& scene,
                   std::size_t geometry,
                   const Array<double>& world_from_object,
                   const std::vector<std::size_t>& materials,
                   const std::optional<Array<float>>& colors,
                   float pass_index,
                   const std::optional<Array<float>>& randoms,
                   const std::vector<std::string>& hidden_from,
                   bool is_holdout,
                   const std::map<std::string, Array<float>>& attributes,
                   bool is_shadow_catcher,
                   const std::string& name,
                   const std::string& asset,
                   const std::string& light_group,
                   std::uint64_t lit_classes,
                   int blocker_set,
                   int light_class,
                   std::uint32_t blocker_sets,
                   const std::optional<Array<double>>& motion,
                   float terminator_cosine)
{
    const LightLinks links = links_from(lit_classes, blocker_set);
    if (world_from_object.ndim() != 3 || world_from_object.shape(1) != 4 ||
        world_from_object.shape(2) != 4) {
        throw std::invalid_argument("world_from_object has shape " +
                                    shape_text(world_from_object) + "; expected (n, 4, 4)");
    }
    const py::ssize_t count = world_from_object.shape(0);
    if (colors && (colors->ndim() != 2 || colors->shape(0) != count || colors->shape(1) != 4)) {
        throw std::invalid_argument("colors has shape " + shape_text(*colors) + "; expected (" +
                                    std::to_string(count) + ", 4)");
    }
    if (randoms && (randoms->ndim() != 1 || randoms->shape(0) != count)) {
        throw std::invalid_argument("randoms has shape " + shape_text(*randoms) + "; expected (" +
                                    std::to_string(count) + ",)");
    }
    if (motion && (motion->ndim() != 4 || motion->shape(0) != count || motion->shape(2) != 4 ||
                   motion->shape(3) != 4)) {
        throw std::invalid_argument("motion has shape " + shape_text(*motion) + "; expected (" +
                                    std::to_string(count) + ", steps, 4, 4)");
    }
    for (const auto& [attribute, values] : attributes) {
        if (values.ndim() != 2 || values.shape(0) != count || values.shape(1) != 4) {
            throw std::invalid_argument("attribute '" + attribute + "' has shape " +
                                        shape_text(values) + "; expected (" +
                                        std::to_string(count) + ", 4)");
        }
    }
    const Visibility visibility = visibility_from(hidden_from);
    const int group = scene.light_group(light_group);
    for (py::ssize_t i = 0; i < count; ++i) {
        ObjectLook look{.pass_index = pass_index};
        if (colors) {
            const float* c = colors->data(i, 0);
            look.color = Color4f(c[0], c[1], c[2], c[3]);
        }
        if (randoms) {
            look.random = *randoms->data(i);
        }
        for (const auto& [attribute, values] : attributes) {
            if (const auto number = scene.attribute_number(attribute)) {
                const float* c = values.data(i, 0);
                look.properties.push_back(
                    {.attribute = *number, .value = Color4f(c[0], c[1], c[2], c[3])});
            }
        }
        scene.add_instance({.geometry = geometry,
                            .world_from_object = matrix_from(world_from_object.data(i, 0, 0)),
                            .materials = materials,
                            .look = look,
                            .visibility = visibility,
                            .is_holdout = is_holdout,
                            .is_shadow_catcher = is_shadow_catcher,
                            .terminator_cosine = terminator_cosine,
                            .matte = {.object = matte_id(name), .asset = matte_id(asset)},
                            .light_group = group,
                            .links = links,
                            .linked = {.light_class = light_class, .blocker_sets = blocker_sets},
                            .motion = motion ? motion_of(*motion, i) : std::vector<M44d>{}});
    }
}

}  // namespace

void bind_instances(SceneClass& scene)
{
    using namespace py::literals;

    scene.def(
        "add_instances", &add_instances, "geometry"_a, "world_from_object"_a,
        "materials"_a = py::list(), py::kw_only(), "colors"_a = py::none(), "pass_index"_a = 0.0f,
        "randoms"_a = py::none(), "hidden_from"_a = py::list(), "is_holdout"_a = false,
        "attributes"_a = py::dict(), "is_shadow_catcher"_a = false, "name"_a = "", "asset"_a = "",
        "light_group"_a = "", "lit_classes"_a = LightLinks{}.lit_classes, "blocker_set"_a = 0,
        "light_class"_a = 0, "blocker_sets"_a = 0, "motion"_a = py::none(),
        "terminator_cosine"_a = 0.0f,
        "Places a geometry at each of the matrices (n, 4, 4), one material a slot.\n\n"
        "For the Object Info node: colors (n, 4), pass_index, and randoms (n,) in [0, 1).\n"
        "hidden_from: CAMERA, DIFFUSE, GLOSSY, TRANSMISSION, VOLUME_SCATTER, SHADOW rays.\n"
        "A holdout is cut out of the picture; of a shadow catcher only what objects change is\n"
        "seen. attributes (n, 4): of the objects, where the geometry has none of the name.\n"
        "name, asset: for Cryptomatte, of the object and of what it is part of.\n"
        "motion: the matrices (n, steps, 4, 4) at equally spaced times from the shutter's\n"
        "opening to its close; world_from_object is that half way.\n"
        "For light linking: the class of the object, and bit n - 1 for each set n of blockers\n"
        "that it is in; if it shines, the classes (bits) that it lights and the set that blocks\n"
        "its light (0: all). terminator_cosine: of light that grazes smooth triangles so much,\n"
        "shadow rays start from the round surface.\n\n"
        "Raises ValueError for an array of another shape, and for what the scene lacks.");
}

}  // namespace eye_render
