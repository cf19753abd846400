// What a material reads of a mesh: coordinates, layers and tangents, of mirrored and stretched
// objects as well.

#include "scene/mesh_attributes.h"

#include "scene/transform.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

// A square of half width 1 in z = 0 facing +Z, u along x and v along y.
Mesh square()
{
    Mesh mesh;
    mesh.name = "square";
    mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.uv_layers = {{"UVMap", {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}}};
    return mesh;
}

// One square at one place, without rays.
class Placed {
public:
    explicit Placed(Mesh mesh, const M44d& world_from_object = {}, const V3d& eye = V3d(0.0))
        : geometry_(std::move(mesh)), space_(texture_space_of(geometry_))
    {
        const M44d relative = relative_to_eye(world_from_object, eye);
        frame_.eye_position_world = eye;
        placement_ = {.geometry = &geometry_,
                      .layers = &layers_,
                      .texture_space = &space_,
                      .materials = {&material_},
                      .pose = {.world_from_object = to_float(relative),
                               .world_from_object_normal = normal_matrix(relative)},
                      .is_mirrored = is_mirror(relative),
                      .look = {},
                      .visibility = {},
                      .matte = {},
                      .links = {},
                      .emitters = {}};
    }
    Placed(const Placed&) = delete;
    Placed& operator=(const Placed&) = delete;

    [[nodiscard]] MeshAttributes at(float u, float v, std::uint32_t triangle = 0) const
    {
        return {placement_, placement_.pose, triangle, u, v, shutter_middle, frame_};
    }

    LayerLookup layers_{.uv = {0, LayerLookup::none}, .attributes = {0, LayerLookup::none}};
    Placement placement_;
    Material material_ = plain_material("BSDF_DIFFUSE", {});

private:
    Geometry geometry_;
    TextureSpace space_;
    SceneFrame frame_;
};

M44d stretched(const V3d& scale, const V3d& at = V3d(0.0))
{
    M44d m;
    m.setScale(scale);
    for (int axis = 0; axis < 3; ++axis) {
        m[3][axis] = at[axis];
    }
    return m;
}

constexpr float rounding = 2e-6f;

TEST(MeshAttributes, place_is_told_in_three_spaces)
{
    // The eye stands far off: what a node reads counts from the world's origin all the same.
    const Placed square_there(square(), stretched({2, 3, 1}, {10, 20, 30}), {9, 18, 33});
    const MeshAttributes at = square_there.at(0.25f, 0.5f);  // a quarter of corner 1, half of 2
    EXPECT_LT((at.position_object() - V3f(0.5f, 0.0f, 0.0f)).length(), rounding);
    EXPECT_LT((at.position_world() - V3f(11.0f, 20.0f, 30.0f)).length(), 32.0f * rounding);
    EXPECT_LT((at.generated() - V3f(0.75f, 0.5f, 0.5f)).length(), rounding);
}

TEST(MeshAttributes, generated_follows_the_texture_space_that_the_mesh_brings)
{
    Mesh mesh = square();
    mesh.texture_space = TextureSpace{.origin = {-3, 0, 1}, .size = {4, 2, 0.5f}};
    const Placed placed(mesh);
    EXPECT_LT((placed.at(0.0f, 1.0f).generated() - V3f(1.0f, 0.5f, -2.0f)).length(), rounding);
}

TEST(MeshAttributes, layers_are_read_where_the_ray_met_the_mesh_and_missing_ones_are_told)
{
    Mesh mesh = square();
    mesh.attributes = {{"Col", std::vector<Color4f>(6, Color4f(0.0f))}};
    mesh.attributes[0].per_corner[1] = Color4f(1.0f, 2.0f, 3.0f, 4.0f);
    const Placed placed(mesh);
    const MeshAttributes at = placed.at(0.25f, 0.5f);
    EXPECT_LT((at.uv(0) - V2f(0.75f, 0.5f)).length(), rounding);
    EXPECT_EQ(at.uv(1), V2f(0.0f));
    EXPECT_TRUE(at.attribute(0).exists);
    EXPECT_EQ(at.attribute(0).value, Color4f(0.25f, 0.5f, 0.75f, 1.0f));
    EXPECT_FALSE(at.attribute(1).exists);
    EXPECT_EQ(at.tangent(1).tangent, V3f(0.0f));
}

TEST(MeshAttributes, tangent_follows_u_and_bitangent_follows_v_also_when_mirrored)
{
    for (const double scale_x : {1.0, -1.0}) {
        const Placed placed(square(), stretched({scale_x, 1, 1}));
        const MeshAttributes at = placed.at(0.3f, 0.3f);
        const TangentFrame frame = at.tangent(0);
        EXPECT_EQ(frame.tangent, V3f(static_cast<float>(scale_x), 0, 0));
        const V3f bitangent = at.smooth_normal().cross(frame.tangent) * frame.bitangent_sign;
        EXPECT_EQ(bitangent, V3f(0, 1, 0)) << scale_x;
    }
}

TEST(MeshAttributes, map_that_covers_no_area_has_no_tangent)
{
    Mesh mesh = square();
    mesh.uv_layers[0].per_corner.assign(6, V2f(0.5f));
    const Placed placed(mesh);
    EXPECT_EQ(placed.at(0.3f, 0.3f).tangent(0).tangent, V3f(0.0f));
}

TEST(MeshAttributes, smooth_normal_keeps_the_meshs_side)
{
    Mesh mesh = square();
    mesh.normal_domain = NormalDomain::PerVertex;
    mesh.normals.assign(4, V3f(0.6f, 0.0f, 0.8f));
    for (const double scale_x : {1.0, -1.0}) {
        const Placed flat(square(), stretched({scale_x, 1, 1}));
        EXPECT_EQ(flat.at(0.3f, 0.3f).smooth_normal(), V3f(0, 0, 1)) << scale_x;
        const Placed smooth(mesh, stretched({scale_x, 1, 1}));
        EXPECT_LT((smooth.at(0.3f, 0.3f).smooth_normal() -
                   V3f(0.6f * static_cast<float>(scale_x), 0.0f, 0.8f))
                      .length(),
                  rounding);
    }
    // Stretched twice along x, a slope of 3/4 is one of 3/8.
    const Placed wide(mesh, stretched({2, 1, 1}));
    const V3f n = wide.at(0.3f, 0.3f).smooth_normal();
    EXPECT_NEAR(n.x / n.z, 0.375f, rounding);
}

TEST(MeshAttributes, edge_distance_is_in_world_units)
{
    // Corners (0, 0), (6, 0) and (6, 4) in the world: from (4, 1) the nearest edge is y = 0, from
    // (5.9, 2) it is x = 6, and the diagonal passes 0.1 above (1.8, 1.1).
    const Placed placed(square(), stretched({3, 2, 1}, {3, 2, 0}));
    const auto distance_at = [&](float x, float y) {
        return placed.at((x - 1.5f * y) / 6.0f, y / 4.0f).edge_distance();
    };
    EXPECT_NEAR(distance_at(4.0f, 1.0f), 1.0f, rounding);
    EXPECT_NEAR(distance_at(5.9f, 2.0f), 0.1f, rounding);
    EXPECT_NEAR(distance_at(1.8f, 1.1f), 0.1f * std::cos(std::atan(2.0f / 3.0f)), rounding);
}

TEST(MeshAttributes, moved_is_what_would_be_read_further_along_the_surface)
{
    const Placed placed(square(), stretched({-2, 3, 1}, {0, 0, 5}), {1, 1, 1});
    const MeshAttributes at = placed.at(0.25f, 0.5f);
    // Also beyond the triangle's edge, and what is across the surface does not count.
    for (const V3f& offset : {V3f(0.5f, -0.25f, 0.0f), V3f(-4.0f, 9.0f, 0.0f)}) {
        bool was_shown = false;
        at.moved(offset + V3f(0.0f, 0.0f, 7.0f), [&](const HitAttributes& there) {
            was_shown = true;
            EXPECT_LT((there.position_world() - at.position_world() - offset).length(), 1e-5f);
            const V2f uv_step(offset.x / -4.0f, offset.y / 6.0f);
            EXPECT_LT((there.uv(0) - at.uv(0) - uv_step).length(), 1e-5f);
        });
        EXPECT_TRUE(was_shown);
    }
}

TEST(MeshAttributes, triangle_without_area_stays_where_it_is)
{
    Mesh mesh = square();
    mesh.positions[2] = mesh.positions[1];
    const Placed placed(mesh);
    const MeshAttributes at = placed.at(0.3f, 0.3f);
    at.moved(V3f(1.0f), [&](const HitAttributes& there) {
        EXPECT_EQ(there.position_world(), at.position_world());
    });
    EXPECT_EQ(at.edge_distance(), 0.0f);
    EXPECT_EQ(at.smooth_normal().length(), 1.0f);
}

TEST(MeshAttributes, object_is_told_with_its_place_in_the_world)
{
    Placed placed(square(), stretched({2, 2, 2}, {10, 20, 30}), {9, 9, 9});
    placed.placement_.look = {
        .color = Color4f(0.1f, 0.2f, 0.3f, 0.4f), .pass_index = 3.0f, .random = 0.25f};
    placed.material_.pass_index = 7;
    const MeshAttributes at = placed.at(0.25f, 0.5f);
    const ObjectFacts& object = at.object();
    EXPECT_EQ(object.world_from_object.translation(), V3f(10, 20, 30));
    EXPECT_LT((at.position_world() * object.object_from_world - at.position_object()).length(),
              16.0f * rounding);
    EXPECT_EQ(object.color, Color4f(0.1f, 0.2f, 0.3f, 0.4f));
    EXPECT_EQ(object.pass_index, 3.0f);
    EXPECT_EQ(object.material_index, 7.0f);
    EXPECT_EQ(object.random, 0.25f);
}

}  // namespace
}  // namespace eye_render
