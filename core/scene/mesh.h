// A triangle mesh in its own object space, as plain data. Corner data (UV maps, colours, corner
// normals) has three entries a triangle, in the order of `triangles`.

#pragma once

#include "base/vector.h"
#include "scene/motion.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace eye_render {

using TriangleIndices = std::array<std::uint32_t, 3>;

struct UvLayer {
    std::string name;
    std::vector<V2f> per_corner;
};

// Numbers, vectors and colours that materials read by name: a number is in r, g and b.
struct Attribute {
    std::string name;
    std::vector<Color4f> per_corner;  // colours linear, straight alpha
};

// Blender's texture space: where coordinates Generated are 0 and how far it is to 1.
struct TextureSpace {
    V3f origin{0.0f};
    V3f size{1.0f};
};

enum class NormalDomain { Flat, PerVertex, PerCorner };

struct Mesh {
    std::string name;
    std::vector<V3f> positions;
    std::vector<TriangleIndices> triangles;
    NormalDomain normal_domain = NormalDomain::Flat;
    std::vector<V3f> normals;                  // unit; empty when flat
    std::vector<std::int32_t> material_slots;  // per triangle; empty: slot 0 everywhere
    std::vector<UvLayer> uv_layers;            // the first is the one that unnamed requests read
    std::vector<Attribute> attributes;
    std::optional<TextureSpace> texture_space;  // nothing: the bounding box of the positions
    // Positions and normals, if not flat, at the times of motion.h; empty: still. `positions` and
    // `normals` are those at the shutter's middle.
    std::vector<std::vector<V3f>> motion_positions;
    std::vector<std::vector<V3f>> motion_normals;

    [[nodiscard]] std::array<V3f, 3> corners(std::uint32_t triangle, float time) const
    {
        const auto corner = [&](std::size_t i) {
            return at_time(positions, motion_positions, triangles[triangle][i], time);
        };
        return {corner(0), corner(1), corner(2)};
    }
    [[nodiscard]] std::size_t slot(std::uint32_t triangle) const
    {
        return material_slots.empty() ? 0 : static_cast<std::size_t>(material_slots[triangle]);
    }
};

// Throws std::invalid_argument when an index or a length is out of range; such meshes
// are refused here so that no query has to look.
void validate(const Mesh& mesh);

// Leaves out the triangles of a valid mesh with a corner that is not finite; returns how many.
std::size_t drop_broken_triangles(Mesh& mesh);

}  // namespace eye_render
