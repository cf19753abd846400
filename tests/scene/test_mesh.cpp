#include "scene/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

namespace eye_render {
namespace {

Mesh triangle()
{
    Mesh mesh;
    mesh.name = "T";
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    return mesh;
}

std::string refusal(const std::function<void(Mesh&)>& spoil)
{
    Mesh mesh = triangle();
    spoil(mesh);
    try {
        validate(mesh);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

TEST(Mesh, plain_triangle_is_accepted)
{
    EXPECT_EQ(refusal([](Mesh&) {}), "");
}

TEST(Mesh, refusals_name_the_mesh_the_value_and_what_is_allowed)
{
    EXPECT_EQ(refusal([](Mesh& m) {
                  m.triangles = {{0, 1, 3}};
              }),
              "mesh 'T': triangle 0 has vertex 3; expected 0 to 3 (excluded)");
    EXPECT_EQ(refusal([](Mesh& m) {
                  m.normal_domain = NormalDomain::PerCorner;
                  m.normals = {{0, 0, 1}};
              }),
              "mesh 'T': normals has 1 entries; expected 3");
    EXPECT_EQ(refusal([](Mesh& m) {
                  m.uv_layers = {{"UVMap", {{0, 0}}}};
              }),
              "mesh 'T': UV layer 'UVMap' has 1 entries; expected 3");
    EXPECT_EQ(refusal([](Mesh& m) {
                  m.attributes = {{"Col", {}}};
              }),
              "mesh 'T': attribute 'Col' has 0 entries; expected 3");
    EXPECT_EQ(refusal([](Mesh& m) { m.material_slots = {-1}; }),
              "mesh 'T': material slot -1 is negative");
}

TEST(Mesh, triangles_with_a_corner_that_is_not_finite_are_left_out_with_their_data)
{
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {NAN, 0, 0}, {1, 1, INFINITY}};
    mesh.triangles = {{0, 1, 3}, {0, 1, 2}, {2, 4, 1}};
    mesh.material_slots = {7, 8, 9};
    UvLayer uv{.name = "UVMap", .per_corner = {}};
    for (int corner = 0; corner < 9; ++corner) {
        uv.per_corner.emplace_back(static_cast<float>(corner), 0.0f);
        mesh.normals.emplace_back(0.0f, 0.0f, static_cast<float>(corner));
    }
    mesh.normal_domain = NormalDomain::PerCorner;
    mesh.uv_layers = {uv};
    EXPECT_EQ(drop_broken_triangles(mesh), 2u);
    EXPECT_EQ(mesh.triangles, (std::vector<TriangleIndices>{{0, 1, 2}}));
    EXPECT_EQ(mesh.material_slots, std::vector<std::int32_t>{8});
    EXPECT_EQ(mesh.uv_layers[0].per_corner, (std::vector<V2f>{{3, 0}, {4, 0}, {5, 0}}));
    EXPECT_EQ(mesh.normals, (std::vector<V3f>{{0, 0, 3}, {0, 0, 4}, {0, 0, 5}}));
    validate(mesh);
    // Unused positions stay, so that the indices do, but reach no box.
    EXPECT_EQ(mesh.positions[3], V3f(0.0f));
    EXPECT_EQ(mesh.positions[4], V3f(0.0f));
    EXPECT_EQ(drop_broken_triangles(mesh), 0u);
}

}  // namespace
}  // namespace eye_render
