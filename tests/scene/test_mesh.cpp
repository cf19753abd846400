#include "scene/mesh.h"

#include <gtest/gtest.h>

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
                  m.color_attributes = {{"Col", {}}};
              }),
              "mesh 'T': colour attribute 'Col' has 0 entries; expected 3");
    EXPECT_EQ(refusal([](Mesh& m) { m.material_slots = {-1}; }),
              "mesh 'T': material slot -1 is negative");
}

}  // namespace
}  // namespace eye_render
