// eyecore.Scene: meshes, strands and points from NumPy arrays.

#include "bind_scene.h"

#include <map>
#include <optional>

namespace eye_render {

namespace {

using GivenTextureSpace = std::array<std::array<float, 3>, 2>;
using GivenLayers = std::map<std::string, Array<float>>;

std::optional<TextureSpace> texture_space_from(const std::optional<GivenTextureSpace>& given)
{
    if (!given) {
        return std::nullopt;
    }
    const auto& [origin, size] = *given;
    return TextureSpace{.origin = {origin[0], origin[1], origin[2]},
                        .size = {size[0], size[1], size[2]}};
}

// The active layer comes first.
template <typename Layer>
void fill_layers(std::vector<Layer>& layers, const GivenLayers& given, const std::string& active)
{
    for (const auto& [name, values] : given) {
        const auto at = name == active ? layers.begin() : layers.end();
        layers.insert(at, {name, rows<V2f>(values, "UV layer '" + name + "'")});
    }
}

template <typename Attribute>
void fill_attributes(std::vector<Attribute>& attributes, const GivenLayers& given)
{
    for (const auto& [name, values] : given) {
        attributes.push_back({name, rows<Color4f>(values, "attribute '" + name + "'")});
    }
}

// (n, 3) or (m, 3, 3).
std::vector<V3f> normals_from(Array<float> normals)
{
    return rows<V3f>(normals.ndim() == 3 ? Array<float>(normals.reshape({-1, 3})) : normals,
                     "normals");
}

std::vector<SizedPoint> sized_points(const Array<float>& positions, const Array<float>& radii)
{
    const std::vector<V3f> centers = rows<V3f>(positions, "positions");
    if (radii.ndim() != 1 || static_cast<std::size_t>(radii.shape(0)) != centers.size()) {
        throw std::invalid_argument("radii has shape " + shape_text(radii) + "; expected (" +
                                    std::to_string(centers.size()) + ",)");
    }
    std::vector<SizedPoint> points;
    points.reserve(centers.size());
    for (std::size_t i = 0; i < centers.size(); ++i) {
        points.push_back({centers[i], radii.data()[i]});
    }
    return points;
}

// Positions at the times of the motion; radii do not change.
std::vector<std::vector<SizedPoint>> motion_from(const std::vector<Array<float>>& positions,
                                                 const Array<float>& radii)
{
    std::vector<std::vector<SizedPoint>> motion;
    motion.reserve(positions.size());
    for (const Array<float>& step : positions) {
        motion.push_back(sized_points(step, radii));
    }
    return motion;
}

std::size_t add_mesh(SceneBuilder& scene,
                     const std::string& name,
                     const Array<float>& positions,
                     const Array<std::uint32_t>& triangles,
                     const std::optional<Array<float>>& normals,
                     const GivenLayers& uvs,
                     const GivenLayers& attributes,
                     const std::optional<Array<std::int32_t>>& material_slots,
                     const std::string& active_uv,
                     const std::optional<GivenTextureSpace>& texture_space,
                     const std::vector<Array<float>>& motion_positions,
                     const std::vector<Array<float>>& motion_normals)
{
    Mesh mesh;
    mesh.name = name;
    mesh.positions = rows<V3f>(positions, "positions");
    mesh.triangles = rows<TriangleIndices>(triangles, "triangles");
    if (normals) {
        mesh.normals = normals_from(*normals);
        mesh.normal_domain =
            normals->ndim() == 3 ? NormalDomain::PerCorner : NormalDomain::PerVertex;
    }
    for (const Array<float>& step : motion_positions) {
        mesh.motion_positions.push_back(rows<V3f>(step, "motion_positions"));
    }
    for (const Array<float>& step : motion_normals) {
        mesh.motion_normals.push_back(normals_from(step));
    }
    fill_layers(mesh.uv_layers, uvs, active_uv);
    fill_attributes(mesh.attributes, attributes);
    mesh.texture_space = texture_space_from(texture_space);
    if (material_slots) {
        mesh.material_slots.assign(material_slots->data(),
                                   material_slots->data() + material_slots->size());
    }
    return scene.add_geometry(std::move(mesh));
}

std::size_t add_curves(SceneBuilder& scene,
                       const std::string& name,
                       const Array<float>& positions,
                       const Array<float>& radii,
                       const Array<std::uint32_t>& first_keys,
                       const std::string& shape,
                       const GivenLayers& uvs,
                       const GivenLayers& attributes,
                       const std::string& active_uv,
                       const std::optional<GivenTextureSpace>& texture_space,
                       const std::vector<Array<float>>& motion_positions)
{
    Curves curves;
    curves.name = name;
    curves.keys = sized_points(positions, radii);
    curves.first_keys.assign(first_keys.data(), first_keys.data() + first_keys.size());
    curves.shape = named<StrandShape>("shape", shape,
                                      {{"ROUND", StrandShape::Round},
                                       {"ROUND_LINEAR", StrandShape::RoundLinear},
                                       {"RIBBON", StrandShape::Ribbon}});
    fill_layers(curves.uv_layers, uvs, active_uv);
    fill_attributes(curves.attributes, attributes);
    curves.texture_space = texture_space_from(texture_space);
    curves.motion = motion_from(motion_positions, radii);
    return scene.add_geometry(std::move(curves));
}

std::size_t add_points(SceneBuilder& scene,
                       const std::string& name,
                       const Array<float>& positions,
                       const Array<float>& radii,
                       const GivenLayers& attributes,
                       const std::optional<GivenTextureSpace>& texture_space,
                       const std::vector<Array<float>>& motion_positions)
{
    Points points;
    points.name = name;
    points.points = sized_points(positions, radii);
    fill_attributes(points.attributes, attributes);
    points.texture_space = texture_space_from(texture_space);
    points.motion = motion_from(motion_positions, radii);
    return scene.add_geometry(std::move(points));
}

}  // namespace

void bind_geometry(SceneClass& scene)
{
    using namespace py::literals;

    scene
        .def("add_mesh", &add_mesh, "name"_a, "positions"_a, "triangles"_a, py::kw_only(),
             "normals"_a = py::none(), "uvs"_a = py::dict(), "attributes"_a = py::dict(),
             "material_slots"_a = py::none(), "active_uv"_a = "", "texture_space"_a = py::none(),
             "motion_positions"_a = py::list(), "motion_normals"_a = py::list(),
             "Number of a mesh: positions (n, 3), triangles (m, 3), normals (n, 3) or (m, 3, 3),\n"
             "UV layers (3 m, 2), attributes (3 m, 4), colours among them linear, material_slots\n"
             "(m,), texture_space ((x, y, z) of Generated 0, size). Motion: positions, and "
             "normals\n"
             "if there are any, at equally spaced times from the shutter's opening to its close;\n"
             "`positions` and `normals` are those half way.")
        .def("add_curves", &add_curves, "name"_a, "positions"_a, "radii"_a, "first_keys"_a,
             py::kw_only(), "shape"_a = "ROUND", "uvs"_a = py::dict(), "attributes"_a = py::dict(),
             "active_uv"_a = "", "texture_space"_a = py::none(), "motion_positions"_a = py::list(),
             "Number of strands: positions (n, 3) and radii (n,) of the keys of all strands from\n"
             "root to tip, the number (s,) of each strand's first key, shape ROUND, ROUND_LINEAR\n"
             "or RIBBON, UV layers (s, 2), attributes (n, 4); else as add_mesh.")
        .def("add_points", &add_points, "name"_a, "positions"_a, "radii"_a, py::kw_only(),
             "attributes"_a = py::dict(), "texture_space"_a = py::none(),
             "motion_positions"_a = py::list(),
             "Number of a cloud of balls: positions (n, 3), radii (n,), attributes (n, 4); else "
             "as\n"
             "add_mesh.");
}

}  // namespace eye_render
