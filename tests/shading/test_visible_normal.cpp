#include "shading/visible_normal.h"

#include "made_up_hit.h"
#include "scattering.h"
#include "shading/material.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::MadeUpHit;
using test::up;

TEST(VisibleNormal, is_left_alone_where_a_mirror_works)
{
    const V3f normal = direction_at(20.0, 40.0);
    EXPECT_EQ(visible_normal(normal, direction_at(20.0), up), normal);
}

TEST(VisibleNormal, is_bent_until_the_mirror_direction_leaves_the_surface)
{
    for (double view_deg : {10.0, 60.0, 85.0, 89.99}) {
        for (double normal_deg : {0.0, 40.0, 70.0, 95.0, 170.0}) {
            for (double azimuth_deg : {0.0, 90.0, 180.0}) {
                const V3f wo = direction_at(view_deg);
                const V3f n = visible_normal(direction_at(normal_deg, azimuth_deg), wo, up);
                const V3f mirrored = n * (2.0f * n.dot(wo)) - wo;
                EXPECT_NEAR(n.length(), 1.0f, 1e-5f);
                EXPECT_GT(n.dot(wo), 0.0f) << view_deg << " " << normal_deg << " " << azimuth_deg;
                EXPECT_GT(mirrored.z, 0.0f) << view_deg << " " << normal_deg << " " << azimuth_deg;
            }
        }
    }
}

TEST(VisibleNormal, a_socket_may_bring_any_length_but_none)
{
    const V3f fallback = direction_at(10.0);
    EXPECT_LT((unit_normal(direction_at(40.0) * 7.0f, fallback) - direction_at(40.0)).length(),
              1e-6f);
    EXPECT_EQ(unit_normal(V3f(0.0f), fallback), fallback);
    EXPECT_EQ(unit_normal(V3f(NAN), fallback), fallback);
    EXPECT_EQ(unit_normal(V3f(INFINITY), fallback), fallback);
}

ShadedPoint shaded(const Material& material, const ShadingPoint& point)
{
    const MadeUpHit hit;
    const PathState path;
    return material.surface.shade({.point = point, .attributes = hit, .path = path});
}

TEST(VisibleNormal, a_rough_mirror_is_not_black_where_interpolation_turns_it_away)
{
    const Material m =
        plain_material("BSDF_GLOSSY", {{"Color", V3f(1.0f)}, {"Roughness", V3f(0.5f)}});
    const ShadingPoint point{.wo = direction_at(80.0), .ng = up, .ns = direction_at(30.0, 180.0)};
    EXPECT_GT(test::integrate(shaded(m, point).bsdf).value.x, 0.3);
}

TEST(VisibleNormal, a_mapped_one_fades_out_before_the_smooth_one_turns_from_the_light)
{
    const Material m =
        plain_material("BSDF_DIFFUSE", {{"Color", V3f(1.0f)}, {"Normal", direction_at(50.0)}});
    const ShadingPoint point{.wo = direction_at(20.0), .ng = up, .ns = up};
    const Bsdf bsdf = shaded(m, point).bsdf;
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
