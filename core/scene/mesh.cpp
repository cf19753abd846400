#include "scene/mesh.h"

#include <algorithm>
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

void validate_motion(const Mesh& mesh)
{
    if (mesh.motion_positions.size() == 1) {
        refuse(mesh, "motion has 1 step; expected none or at least 2");
    }
    for (const std::vector<V3f>& step : mesh.motion_positions) {
        check_length(mesh, "a step of the motion", step.size(), mesh.positions.size());
    }
    const bool has_normals =
        mesh.normal_domain != NormalDomain::Flat && !mesh.motion_positions.empty();
    check_length(mesh, "the motion's normals", mesh.motion_normals.size(),
                 has_normals ? mesh.motion_positions.size() : 0);
    for (const std::vector<V3f>& step : mesh.motion_normals) {
        check_length(mesh, "a step of the motion's normals", step.size(), mesh.normals.size());
    }
}

bool is_finite(const V3f& p) { return std::isfinite(p.x + p.y + p.z); }

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
    for (const Attribute& attribute : mesh.attributes) {
        check_length(mesh, "attribute '" + attribute.name + "'", attribute.per_corner.size(),
                     corners);
    }
    validate_motion(mesh);
}

std::size_t drop_broken_triangles(Mesh& mesh)
{
    std::vector<std::vector<V3f>*> poses{&mesh.positions};
    for (std::vector<V3f>& step : mesh.motion_positions) {
        poses.push_back(&step);
    }
    const auto is_whole = [](const std::vector<V3f>* pose) {
        return std::ranges::all_of(*pose, is_finite);
    };
    if (std::ranges::all_of(poses, is_whole)) {
        return 0;
    }
    const auto is_broken = [&poses](const TriangleIndices& triangle) {
        return std::ranges::any_of(triangle, [&poses](std::uint32_t index) {
            return std::ranges::any_of(poses, [index](const std::vector<V3f>* pose) {
                return !is_finite((*pose)[index]);
            });
        });
    };
    std::vector<bool> keep;
    keep.reserve(mesh.triangles.size());
    for (const TriangleIndices& triangle : mesh.triangles) {
        keep.push_back(!is_broken(triangle));
    }
    const auto filter = [&keep](auto& values, std::size_t per_triangle) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            if (keep[i / per_triangle]) {
                values[kept++] = values[i];
            }
        }
        values.resize(kept);
    };
    const std::size_t before = mesh.triangles.size();
    filter(mesh.triangles, 1);
    filter(mesh.material_slots, 1);
    if (mesh.normal_domain == NormalDomain::PerCorner) {
        filter(mesh.normals, 3);
        for (std::vector<V3f>& step : mesh.motion_normals) {
            filter(step, 3);
        }
    }
    for (UvLayer& layer : mesh.uv_layers) {
        filter(layer.per_corner, 3);
    }
    for (Attribute& attribute : mesh.attributes) {
        filter(attribute.per_corner, 3);
    }
    for (std::vector<V3f>* pose : poses) {
        for (V3f& p : *pose) {
            p = is_finite(p) ? p : V3f(0.0f);  // no triangle refers to it any more
        }
    }
    return before - mesh.triangles.size();
}

}  // namespace eye_render
