#include "made_up_hit.h"
#include "scattering.h"
#include "shading/shading_normal.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::constant;
using test::direction_at;
using test::from_texture;
using test::MadeUpHit;
using test::up;

constexpr float rounding = 1e-6f;

ShadingPoint flat_point() { return {.wo = direction_at(20.0), .ng = up, .ns = up}; }

// The texel of a tangent-space normal.
Color4f texel_of(const V3f& n)
{
    return {0.5f + 0.5f * n.x, 0.5f + 0.5f * n.y, 0.5f + 0.5f * n.z, 1.0f};
}

V3f mapped(const V3f& tangent_space_normal, const ShadingPoint& point, float strength = 1.0f)
{
    MadeUpHit hit;
    hit.texel = texel_of(tangent_space_normal);
    const Material m{.normal_map = from_texture(), .normal_strength = constant(strength)};
    return mapped_normal(m, point, hit);
}

TEST(ShadingNormal, red_is_along_the_tangent_and_green_up_across_it)
{
    EXPECT_LT((mapped({0.6f, 0.0f, 0.8f}, flat_point()) - V3f(0.6f, 0.0f, 0.8f)).length(),
              rounding);
    EXPECT_LT((mapped({0.0f, 0.6f, 0.8f}, flat_point()) - V3f(0.0f, 0.6f, 0.8f)).length(),
              rounding);
}

TEST(ShadingNormal, a_mirrored_map_turns_green_over)
{
    MadeUpHit hit;
    hit.texel = texel_of({0.0f, 0.6f, 0.8f});
    hit.frame.bitangent_sign = -1.0f;
    const Material m{.normal_map = from_texture()};
    EXPECT_LT((mapped_normal(m, flat_point(), hit) - V3f(0.0f, -0.6f, 0.8f)).length(), rounding);
}

TEST(ShadingNormal, strength_blends_from_flat)
{
    EXPECT_EQ(mapped({0.6f, 0.0f, 0.8f}, flat_point(), 0.0f), up);
    const V3f half = mapped({0.6f, 0.0f, 0.8f}, flat_point(), 0.5f);
    EXPECT_NEAR(half.x / half.z, 0.3f / 0.9f, rounding);
    const V3f twice = mapped({0.6f, 0.0f, 0.8f}, flat_point(), 2.0f);
    EXPECT_NEAR(twice.x / twice.z, 1.2f / 0.8f, rounding);
}

TEST(ShadingNormal, the_back_of_a_bump_is_a_dent)
{
    // Seen from behind: the point is turned to the viewer, the mesh and its tangent are not.
    ShadingPoint point = flat_point();
    point.backfacing = true;
    EXPECT_LT((mapped({0.6f, 0.0f, 0.8f}, point) - V3f(-0.6f, 0.0f, 0.8f)).length(), rounding);
}

TEST(ShadingNormal, without_a_map_or_a_tangent_it_is_the_interpolated_one)
{
    MadeUpHit hit;
    EXPECT_EQ(mapped_normal(Material{}, flat_point(), hit), up);
    EXPECT_EQ(hit.questions, 0);
    hit.frame.tangent = V3f(0.0f);
    EXPECT_EQ(mapped_normal(Material{.normal_map = from_texture()}, flat_point(), hit), up);
}

TEST(ShadingNormal, is_left_alone_where_a_mirror_works)
{
    const V3f normal = direction_at(20.0, 40.0);
    EXPECT_EQ(visible_normal(normal, flat_point()), normal);
}

TEST(ShadingNormal, is_bent_until_the_mirror_direction_leaves_the_surface)
{
    for (double view_deg : {10.0, 60.0, 85.0, 89.99}) {
        for (double normal_deg : {0.0, 40.0, 70.0, 95.0, 170.0}) {
            for (double azimuth_deg : {0.0, 90.0, 180.0}) {
                const ShadingPoint point{.wo = direction_at(view_deg), .ng = up, .ns = up};
                const V3f n = visible_normal(direction_at(normal_deg, azimuth_deg), point);
                const V3f mirrored = n * (2.0f * n.dot(point.wo)) - point.wo;
                EXPECT_NEAR(n.length(), 1.0f, 1e-5f);
                EXPECT_GT(n.dot(point.wo), 0.0f)
                    << view_deg << " " << normal_deg << " " << azimuth_deg;
                EXPECT_GT(mirrored.z, 0.0f) << view_deg << " " << normal_deg << " " << azimuth_deg;
            }
        }
    }
}

TEST(ShadingNormal, a_rough_mirror_is_not_black_where_interpolation_turns_it_away)
{
    const Material m{.surface = Surface::Glossy, .base_color = constant(1.0f)};
    const ShadingPoint point{.wo = direction_at(80.0), .ng = up, .ns = direction_at(30.0, 180.0)};
    const Bsdf bsdf = shade(m, point, MadeUpHit()).bsdf;
    EXPECT_GT(test::integrate(bsdf).value.x, 0.3);
}

TEST(ShadingNormal, a_mapped_normal_fades_out_before_the_smooth_one_turns_from_the_light)
{
    MadeUpHit hit;
    hit.texel = texel_of(direction_at(50.0));
    const Material m{
        .surface = Surface::Diffuse, .base_color = constant(1.0f), .normal_map = from_texture()};
    const Bsdf bsdf = shade(m, flat_point(), hit).bsdf;
    // Light from the side the bump faces, nearly along the surface: unsoftened it would be lit by
    // cos 39.9 degrees and the edge to the shadow would be sharp.
    EXPECT_LT(bsdf.evaluate(direction_at(89.9)).value.x, 0.01f);
    // Light on the other side of the bump is not changed.
    const V3f wi = direction_at(20.0, 180.0);
    const float cos_i = wi.dot(direction_at(50.0));
    EXPECT_NEAR(bsdf.evaluate(wi).value.x, cos_i / float(pi), 1e-5f);
}

}  // namespace
}  // namespace eye_render
