// Strands as data, and rays against strands whose surface is known: cylinders, cones, ribbons.

#include "scene/curve_attributes.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

// One straight strand up the z axis at the origin, 4 long, in four parts.
Curves pole(StrandShape shape, float root_radius = 0.5f, float tip_radius = 0.5f)
{
    Curves curves;
    curves.name = "pole";
    curves.shape = shape;
    curves.first_keys = {0};
    for (int i = 0; i <= 4; ++i) {
        const float part = 0.25f * static_cast<float>(i);
        curves.keys.push_back({V3f(0.0f, 0.0f, 4.0f * part - 2.0f),
                               root_radius + part * (tip_radius - root_radius)});
    }
    return curves;
}

SceneData placed(Geometry geometry, const std::vector<M44d>& places = {M44d()})
{
    SceneData data;
    data.geometries.push_back(std::move(geometry));
    for (const M44d& place : places) {
        data.instances.push_back({.geometry = 0, .world_from_object = place, .materials = {}});
    }
    return data;
}

M44d scaled(double factor, const V3d& at = V3d(0.0))
{
    M44d m;
    m.setScale(V3d(factor));
    for (int axis = 0; axis < 3; ++axis) {
        m[3][axis] = at[axis];
    }
    return m;
}

// From the left at height z, `side` beside the axis.
Ray across(float side, float z)
{
    return {.origin = V3f(-5.0f, side, z), .direction = V3f(1.0f, 0.0f, 0.0f)};
}

TEST(Curves, a_straight_strand_is_a_cylinder)
{
    for (const StrandShape shape : {StrandShape::Round, StrandShape::RoundLinear}) {
        const SceneData data = placed(pole(shape));
        const Scene scene(data, V3d(0.0));
        for (const float side : {-0.45f, -0.1f, 0.0f, 0.3f}) {
            const auto hit = scene.intersect(across(side, 0.3f));
            ASSERT_TRUE(hit) << side;
            const float depth = std::sqrt(0.25f - side * side);
            EXPECT_NEAR(hit->t, 5.0f - depth, 1e-4f) << side;
            EXPECT_LT((hit->point.ng - V3f(-depth, side, 0.0f) / 0.5f).length(), 1e-3f) << side;
            EXPECT_FALSE(hit->point.backfacing);
        }
        EXPECT_FALSE(scene.intersect(across(0.51f, 0.3f)));
    }
}

TEST(Curves, a_tapered_strand_of_straight_parts_is_a_cone)
{
    const SceneData data = placed(pole(StrandShape::RoundLinear, 0.8f, 0.2f));
    const Scene scene(data, V3d(0.0));
    // The balls along the axis, of radius r(z) = 0.5 - slope z, touch the cone above their
    // centres, where its own radius is r(z) / sqrt(1 - slope^2).
    const float slope = 0.6f / 4.0f;
    const float z = 0.1f;
    const float radius = (0.5f - slope * z) / std::sqrt(1.0f - slope * slope);
    const auto hit = scene.intersect(across(0.0f, z));
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 5.0f - radius, 1e-4f);
    EXPECT_NEAR(hit->point.ng.z, slope, 1e-3f);
}

TEST(Curves, a_ribbon_has_the_width_of_the_strand_and_the_normals_of_a_cylinder)
{
    const SceneData data = placed(pole(StrandShape::Ribbon));
    const Scene scene(data, V3d(0.0));
    for (const float side : {-0.45f, -0.1f, 0.0f, 0.3f}) {
        const auto hit = scene.intersect(across(side, 0.3f));
        ASSERT_TRUE(hit) << side;
        EXPECT_NEAR(hit->t, 5.0f, 1e-3f);
        const V3f round(-std::sqrt(0.25f - side * side), side, 0.0f);
        // A ribbon is tessellated, across as well.
        EXPECT_LT((hit->point.ns - round / 0.5f).length(), 0.02f) << side;
    }
    EXPECT_FALSE(scene.intersect(across(0.51f, 0.3f)));
}

TEST(Curves, a_ray_that_leaves_a_strand_does_not_meet_it_again)
{
    for (const StrandShape shape :
         {StrandShape::Round, StrandShape::RoundLinear, StrandShape::Ribbon}) {
        const SceneData data = placed(pole(shape));
        const Scene scene(data, V3d(0.0));
        const auto hit = scene.intersect(across(0.3f, 0.3f));
        ASSERT_TRUE(hit);
        for (int i = 0; i < 100; ++i) {
            const float angle = 0.0628f * static_cast<float>(i);
            const V3f wi(std::cos(angle), std::sin(angle), 0.0f);
            EXPECT_FALSE(scene.intersect(hit->ray_towards(wi))) << wi;
        }
    }
}

TEST(Curves, a_strand_is_seen_from_inside_too_with_all_its_directions_turned_round)
{
    const SceneData data = placed(pole(StrandShape::Round, 0.8f, 0.2f));
    const Scene scene(data, V3d(0.0));
    for (const bool is_inside : {false, true}) {
        const auto hit = scene.intersect({.origin = V3f(is_inside ? 0.1f : 3.0f, 0.0f, 0.3f),
                                          .direction = V3f(is_inside ? 1.0f : -1.0f, 0.0f, 0.0f)});
        ASSERT_TRUE(hit) << is_inside;
        EXPECT_EQ(hit->point.backfacing, is_inside);
        // Away from the axis, whatever the taper.
        const float sign = is_inside ? -1.0f : 1.0f;
        EXPECT_LT((hit->point.ng - V3f(sign, 0.0f, 0.0f)).length(), 1e-3f) << is_inside;
        const SceneFrame frame;
        const CurveAttributes at(*hit, hit->p_world, hit->placement->pose, frame);
        EXPECT_LT((at.tangent(0).tangent - V3f(0.0f, 0.0f, sign)).length(), 1e-5f) << is_inside;
    }
}

// A strand there and back: along x at the height z = 0, and back two above.
void add_hook(Curves& curves, float y, float z)
{
    curves.first_keys.push_back(static_cast<std::uint32_t>(curves.keys.size()));
    for (const V2f& xz : {V2f(0, 0), V2f(2, 0), V2f(2, 2), V2f(0, 2)}) {
        curves.keys.push_back({V3f(xz.x, y, z + xz.y), 0.2f});
    }
}

TEST(Curves, a_strand_is_never_in_its_own_shadow_but_in_that_of_others)
{
    for (const StrandShape shape :
         {StrandShape::Round, StrandShape::RoundLinear, StrandShape::Ribbon}) {
        Curves curves;
        curves.shape = shape;
        add_hook(curves, 0.0f, 0.0f);
        add_hook(curves, 0.0f, 4.0f);
        // Of a second place the strands are others.
        for (const std::vector<M44d>& places :
             {std::vector{M44d()}, {M44d(), scaled(1.0, {0.0, 0.0, 8.0})}}) {
            const SceneData data = placed(curves, places);
            const Scene scene(data, V3d(0.0));
            for (std::size_t hook = 0; hook < 2 * places.size(); ++hook) {
                const float z = 4.0f * static_cast<float>(hook);
                const auto hit = scene.intersect(
                    {.origin = V3f(1.0f, -5.0f, z), .direction = V3f(0.0f, 1.0f, 0.0f)});
                ASSERT_TRUE(hit) << hook;
                const Ray up =
                    hit->ray_towards((V3f(1.0f, 0.0f, z + 2.0f) - hit->p_world).normalized());
                const Ray from_nowhere{.origin = up.origin, .direction = up.direction};
                EXPECT_TRUE(scene.is_blocked(from_nowhere)) << hook;
                const auto next = scene.intersect(up);
                const bool is_last = hook + 1 == 2 * places.size();
                ASSERT_EQ(next.has_value(), !is_last) << hook;
                if (next) {
                    EXPECT_GT(next->p_world.z, z + 3.0f) << hook;
                }
            }
        }
    }
}

TEST(Curves, radii_grow_with_the_object)
{
    // Once flat and, because it occurs twice, as a prototype.
    const M44d large = scaled(2.0);
    for (const std::vector<M44d>& places :
         {std::vector{large}, {large, scaled(1.0, {0.0, 50.0, 0.0})}}) {
        const SceneData data = placed(pole(StrandShape::Round), places);
        const Scene scene(data, V3d(0.0));
        const auto hit = scene.intersect(across(0.8f, 0.3f));
        ASSERT_TRUE(hit);
        EXPECT_NEAR(hit->t, 5.0f - std::sqrt(1.0f - 0.64f), 1e-3f);
    }
}

TEST(Curves, a_strand_in_a_stretched_object_has_an_ellipses_normals)
{
    M44d stretched;
    stretched.setScale(V3d(1.0, 3.0, 1.0));
    // It occurs twice, so the accelerator holds it as it is in its object.
    const SceneData data =
        placed(pole(StrandShape::Round), {stretched, scaled(1.0, {0.0, 50.0, 0.0})});
    const Scene scene(data, V3d(0.0));
    for (const float side : {-1.2f, 0.3f, 0.9f}) {
        const auto hit = scene.intersect(across(side, 0.3f));
        ASSERT_TRUE(hit) << side;
        // x^2 + y^2 / 9 = 1 / 4, and its gradient.
        const float x = -std::sqrt(0.25f - side * side / 9.0f);
        EXPECT_NEAR(hit->p_world.x, x, 1e-3f) << side;
        EXPECT_LT((hit->point.ng - V3f(x, side / 9.0f, 0.0f).normalized()).length(), 5e-3f)
            << side;
    }
}

TEST(Curves, a_strand_tells_where_it_was_hit)
{
    Curves curves = pole(StrandShape::Round);
    curves.uv_layers = {{"UVMap", {{0.25f, 0.75f}}}};
    curves.attributes = {{"Col", {}}};
    for (int key = 0; key <= 4; ++key) {
        curves.attributes[0].per_key.emplace_back(0.25f * static_cast<float>(key), 0.0f, 0.0f,
                                                  1.0f);
    }
    SceneData data = placed(std::move(curves), {scaled(2.0, {0.0, 0.0, 100.0})});
    data.attribute_names = {"Col", "missing"};
    const V3d eye(0.0, 0.0, 100.0);
    const Scene scene(data, eye);
    const auto hit = scene.intersect(across(0.0f, 2.0f));  // three quarters up
    ASSERT_TRUE(hit);
    SceneFrame frame;
    frame.eye_position_world = eye;
    const CurveAttributes at(*hit, hit->p_world, hit->placement->pose, frame);
    const auto strand = at.strand();
    ASSERT_TRUE(strand);
    EXPECT_NEAR(strand->intercept, 0.75f, 1e-3f);
    EXPECT_NEAR(strand->length, 4.0f, 1e-5f);
    EXPECT_NEAR(strand->thickness, 1.0f, 1e-5f);
    EXPECT_LT((strand->tangent - V3f(0.0f, 0.0f, 1.0f)).length(), 1e-5f);
    EXPECT_EQ(at.uv(0), V2f(0.25f, 0.75f));
    EXPECT_NEAR(at.attribute(0).value.r, 0.75f, 1e-3f);
    EXPECT_FALSE(at.attribute(1).exists);
    EXPECT_LT((at.position_world() - V3f(-1.0f, 0.0f, 102.0f)).length(), 1e-3f);
    EXPECT_LT((at.position_object() - V3f(-0.5f, 0.0f, 1.0f)).length(), 1e-3f);
    EXPECT_NEAR(at.generated().z, 0.0f, 1e-5f);  // of the root
    EXPECT_FALSE(at.point());
}

TEST(Curves, a_segment_finds_its_strand)
{
    Curves curves;
    curves.first_keys = {0, 3, 5};
    curves.keys.resize(9);
    const std::vector<std::pair<std::size_t, std::size_t>> strand_and_key{{0, 0}, {0, 1}, {1, 3},
                                                                          {2, 5}, {2, 6}, {2, 7}};
    ASSERT_EQ(curves.segments(), strand_and_key.size());
    for (std::size_t segment = 0; segment < curves.segments(); ++segment) {
        const StrandPlace place = strand_place(curves, segment, 0.5f);
        EXPECT_EQ(place.strand, strand_and_key[segment].first) << segment;
        EXPECT_EQ(place.key, strand_and_key[segment].second) << segment;
    }
}

TEST(Curves, length_counts_from_the_root)
{
    const Curves curves = pole(StrandShape::Round);
    const StrandLength length = strand_length(curves, {.strand = 0, .key = 2, .u = 0.5f});
    EXPECT_FLOAT_EQ(length.total, 4.0f);
    EXPECT_FLOAT_EQ(length.to_place, 2.5f);
}

TEST(Curves, broken_ones_are_refused)
{
    const auto refused = [](const auto& spoil) {
        Curves curves = pole(StrandShape::Round);
        spoil(curves);
        EXPECT_THROW(validate(curves), std::invalid_argument);
    };
    validate(pole(StrandShape::Round));
    refused([](Curves& curves) { curves.first_keys = {1}; });
    refused([](Curves& curves) { curves.first_keys = {0, 4}; });
    refused([](Curves& curves) { curves.keys[2].radius = -1.0f; });
    refused([](Curves& curves) { curves.uv_layers = {{"UVMap", {}}}; });
    refused([](Curves& curves) { curves.attributes = {{"Col", {}}}; });
    refused([](Curves& curves) { curves.motion = {curves.keys}; });
    refused([](Curves& curves) { curves.motion = {curves.keys, {}}; });
}

TEST(Curves, strands_that_are_not_finite_are_left_out)
{
    Curves curves = pole(StrandShape::Round);
    curves.first_keys = {0, 3};
    curves.uv_layers = {{"UVMap", {{0, 0}, {1, 1}}}};
    curves.keys[1].center.x = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(drop_broken_strands(curves), 1u);
    EXPECT_EQ(curves.first_keys, std::vector<std::uint32_t>{0});
    ASSERT_EQ(curves.keys.size(), 2u);
    EXPECT_FLOAT_EQ(curves.keys[0].center.z, 1.0f);
    EXPECT_EQ(curves.uv_layers[0].per_strand, std::vector<V2f>({{1, 1}}));
    validate(curves);
}

}  // namespace
}  // namespace eye_render
