// eyecore.Scene: meshes, materials, lights and camera from NumPy arrays.

#include "bind_scene.h"

#include <cmath>
#include <map>
#include <optional>

namespace eye_render {

namespace {

std::size_t add_mesh(SceneBuilder& scene,
                     const std::string& name,
                     const Array<float>& positions,
                     const Array<std::uint32_t>& triangles,
                     const std::optional<Array<float>>& normals,
                     const std::map<std::string, Array<float>>& uvs,
                     const std::map<std::string, Array<float>>& attributes,
                     const std::optional<Array<std::int32_t>>& material_slots,
                     const std::string& active_uv,
                     const std::optional<std::array<std::array<float, 3>, 2>>& texture_space)
{
    Mesh mesh;
    mesh.name = name;
    mesh.positions = rows<V3f>(positions, "positions");
    mesh.triangles = rows<TriangleIndices>(triangles, "triangles");
    if (normals) {
        const bool per_corner = normals->ndim() == 3;
        Array<float> flat = *normals;
        mesh.normals =
            rows<V3f>(per_corner ? Array<float>(flat.reshape({-1, 3})) : flat, "normals");
        mesh.normal_domain = per_corner ? NormalDomain::PerCorner : NormalDomain::PerVertex;
    }
    for (const auto& [layer, values] : uvs) {
        const auto at = layer == active_uv ? mesh.uv_layers.begin() : mesh.uv_layers.end();
        mesh.uv_layers.insert(at, {layer, rows<V2f>(values, "UV layer '" + layer + "'")});
    }
    for (const auto& [attribute, values] : attributes) {
        mesh.attributes.push_back(
            {attribute, rows<Color4f>(values, "attribute '" + attribute + "'")});
    }
    if (texture_space) {
        const auto& [origin, size] = *texture_space;
        mesh.texture_space = TextureSpace{.origin = {origin[0], origin[1], origin[2]},
                                          .size = {size[0], size[1], size[2]}};
    }
    if (material_slots) {
        mesh.material_slots.assign(material_slots->data(),
                                   material_slots->data() + material_slots->size());
    }
    return scene.add_mesh(std::move(mesh));
}

void add_instances(SceneBuilder& scene,
                   std::size_t mesh,
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
                   const std::string& light_group)
{
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
    for (const auto& [name, values] : attributes) {
        if (values.ndim() != 2 || values.shape(0) != count || values.shape(1) != 4) {
            throw std::invalid_argument("attribute '" + name + "' has shape " +
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
        for (const auto& [name, values] : attributes) {
            if (const auto number = scene.attribute_number(name)) {
                const float* c = values.data(i, 0);
                look.properties.push_back(
                    {.attribute = *number, .value = Color4f(c[0], c[1], c[2], c[3])});
            }
        }
        scene.add_instance({.mesh = mesh,
                            .world_from_object = matrix_from(world_from_object.data(i, 0, 0)),
                            .materials = materials,
                            .look = look,
                            .visibility = visibility,
                            .is_holdout = is_holdout,
                            .is_shadow_catcher = is_shadow_catcher,
                            .matte = {.object = matte_id(name), .asset = matte_id(asset)},
                            .light_group = group});
    }
}

void set_camera(SceneBuilder& scene,
                const Array<double>& world_from_camera,
                const std::array<double, 4>& slope_bounds,
                const std::array<int, 2>& resolution,
                const std::optional<std::array<int, 4>>& border,
                const std::array<double, 2>& clip,
                double metres_per_unit)
{
    const M44d matrix = matrix_from(world_from_camera, "world_from_camera");
    const auto row = [&matrix](int i) { return V3d(matrix[i][0], matrix[i][1], matrix[i][2]); };
    CameraFrame frame;
    frame.position_world = row(3);
    // A camera's scale means nothing, as in Blender.
    frame.axis_x = row(0).normalized();
    frame.axis_y = row(1).normalized();
    frame.axis_z = row(2).normalized();
    frame.slope_left = slope_bounds[0];
    frame.slope_right = slope_bounds[1];
    frame.slope_bottom = slope_bounds[2];
    frame.slope_top = slope_bounds[3];
    frame.width_px = resolution[0];
    frame.height_px = resolution[1];
    frame.border = border ? PixelBounds{(*border)[0], (*border)[1], (*border)[2], (*border)[3]}
                          : PixelBounds{0, 0, resolution[0], resolution[1]};
    frame.clip_near = clip[0];
    frame.clip_far = clip[1];
    frame.metres_per_unit = metres_per_unit;
    scene.set_camera(frame);
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
                                               {"SHADOW", &Visibility::to_shadow}}) = false;
    }
    return visibility;
}

void bind_scene(py::module_& m)
{
    using namespace py::literals;

    SceneClass scene(m, "Scene", "What is to be seen.");
    bind_materials(scene);
    bind_lights(scene);
    scene.def(py::init<>())
        .def("add_mesh", &add_mesh, "name"_a, "positions"_a, "triangles"_a, py::kw_only(),
             "normals"_a = py::none(), "uvs"_a = py::dict(), "attributes"_a = py::dict(),
             "material_slots"_a = py::none(), "active_uv"_a = "", "texture_space"_a = py::none(),
             "Number of a mesh: positions (n, 3), triangles (m, 3), normals (n, 3) or (m, 3, 3),\n"
             "UV layers (3 m, 2), attributes (3 m, 4), colours among them linear, material_slots\n"
             "(m,), texture_space ((x, y, z) of Generated 0, size).")
        .def("add_instances", &add_instances, "mesh"_a, "world_from_object"_a,
             "materials"_a = py::list(), py::kw_only(), "colors"_a = py::none(),
             "pass_index"_a = 0.0f, "randoms"_a = py::none(), "hidden_from"_a = py::list(),
             "is_holdout"_a = false, "attributes"_a = py::dict(), "is_shadow_catcher"_a = false,
             "name"_a = "", "asset"_a = "", "light_group"_a = "",
             "Places a mesh at each of the matrices (n, 4, 4), one material a slot. For the "
             "Object\n"
             "Info node: colours (n, 4), pass index, and a random number (n,) in [0, 1).\n"
             "hidden_from: CAMERA, DIFFUSE, GLOSSY, TRANSMISSION, SHADOW rays; a holdout is cut "
             "out of\n"
             "the picture. attributes (n, 4), of objects, where the mesh has none of the name. Of "
             "a\n"
             "shadow catcher only what objects change is seen. name, asset: for Cryptomatte, of "
             "the\n"
             "object and of what it is part of.")
        .def("set_camera", &set_camera, "world_from_camera"_a, "slope_bounds"_a, "resolution"_a,
             "border"_a = py::none(), "clip"_a = std::array<double, 2>{0.001, 1e9},
             "metres_per_unit"_a = 1.0,
             "slope_bounds: left, right, bottom, top of the full frame, as slopes; border: x0, "
             "y0,\n"
             "x1, y1 in pixels, x1 and y1 excluded, from the lower left.")
        .def("uv_layers_read", &SceneBuilder::uv_layers_read, "materials"_a)
        .def("attributes_read", &SceneBuilder::attributes_read, "materials"_a);
}

}  // namespace eye_render
