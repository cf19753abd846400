#include "scene/mesh.h"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace eye_render {

namespace {

[[noreturn]] void refuse(const Mesh& mesh, const std::string& what)
{
    throw std::invalid_argument("mesh '" + mesh.name + "': " + what);
}

void check_length(const Mesh& mesh,
                  const std::string& what,
                  std::size_t given,
                  std::size_t expected)
{
    if (given != expected) {
        refuse(mesh, what + " has " + std::to_string(given) + " entries; expected " +
                         std::to_string(expected));
    }
}

}  // namespace

void validate(const Mesh& mesh)
{
    // Embree numbers vertices with 32 bits, and so do the buffers here.
    if (mesh.positions.size() > std::numeric_limits<std::uint32_t>::max()) {
        refuse(mesh, "more than 4,294,967,295 positions");
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        for (const std::uint32_t index : mesh.triangles[i]) {
            if (index >= mesh.positions.size()) {
                refuse(mesh, "triangle " + std::to_string(i) + " has vertex " +
                                 std::to_string(index) + "; expected 0 to " +
                                 std::to_string(mesh.positions.size()) + " (excluded)");
            }
        }
    }
    const std::size_t corners = 3 * mesh.triangles.size();
    switch (mesh.normal_domain) {
    case NormalDomain::Flat: check_length(mesh, "normals", mesh.normals.size(), 0); break;
    case NormalDomain::PerVertex:
        check_length(mesh, "normals", mesh.normals.size(), mesh.positions.size());
        break;
    case NormalDomain::PerCorner:
        check_length(mesh, "normals", mesh.normals.size(), corners);
        break;
    }
    if (!mesh.material_slots.empty()) {
        check_length(mesh, "material_slots", mesh.material_slots.size(), mesh.triangles.size());
        for (const std::int32_t slot : mesh.material_slots) {
            if (slot < 0) {
                refuse(mesh, "material slot " + std::to_string(slot) + " is negative");
            }
        }
    }
    for (const UvLayer& layer : mesh.uv_layers) {
        check_length(mesh, "UV layer '" + layer.name + "'", layer.per_corner.size(), corners);
    }
    for (const ColorAttribute& attribute : mesh.color_attributes) {
        check_length(mesh, "colour attribute '" + attribute.name + "'",
                     attribute.per_corner.size(), corners);
    }
}

}  // namespace eye_render
