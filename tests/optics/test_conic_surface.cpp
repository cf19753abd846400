// Surfaces against their own equation and Snell's law, and the traps: the other sheet of a
// hyperboloid, distant origins, the rim.

#include "optics/conic_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

constexpr double mm = 1e-3;

ConicSurface toric_cornea()
{
    return {.curvature_x_per_m = 1.0 / 7.4e-3,
            .curvature_y_per_m = 1.0 / 8.1e-3,
            .conic_x = -0.2,
            .conic_y = -0.4};
}

// The eyes' surfaces, every kind of conic and both signs of curvature.
std::vector<ConicSurface> many_surfaces()
{
    return {ConicSurface::of_revolution(0.0, 7.8 * mm, 0.0),
            ConicSurface::of_revolution(0.0, 7.72 * mm, -0.26),
            ConicSurface::of_revolution(3.6 * mm, 12.0 * mm, -7.518749),
            ConicSurface::of_revolution(7.6 * mm, -6.0 * mm, -1.0),
            ConicSurface::of_revolution(7.3 * mm, -5.2 * mm, -1.35),
            ConicSurface::of_revolution(0.0, 9.0 * mm, 2.0),
            ConicSurface::of_revolution(0.0, INFINITY, 0.0),
            toric_cornea()};
}

TEST(ConicSurface, rays_meet_it_where_its_sag_says_from_any_distance)
{
    std::mt19937 random(1);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    for (const ConicSurface& surface : many_surfaces()) {
        for (const double before_m : {0.0, 10.0 * mm, 1.0, 1e3}) {
            for (int i = 0; i < 20; ++i) {
                const V2d at_m(3.0 * mm * uniform(random), 3.0 * mm * uniform(random));
                const V3d point_m(at_m.x, at_m.y,
                                  surface.vertex_m + surface.sag_m(at_m.x, at_m.y).value());
                const V3d inward =
                    V3d(0.3 * uniform(random), 0.3 * uniform(random), 1.0).normalized();
                for (const double sense : {1.0, -1.0}) {
                    const auto hit_m = surface.intersection(
                        {point_m - inward * (sense * before_m), inward * sense});
                    ASSERT_TRUE(hit_m.has_value()) << point_m << inward;
                    EXPECT_NEAR((*hit_m - point_m).length(), 0.0, 1e-15 + 1e-15 * before_m)
                        << point_m << inward;
                    EXPECT_TRUE(surface.is_on_vertex_side(*hit_m));
                }
            }
        }
    }
}

TEST(ConicSurface, normal_is_the_gradient_of_the_sag)
{
    constexpr double h_m = 1e-7;
    for (const ConicSurface& surface : many_surfaces()) {
        const V2d at_m(1.5 * mm, -0.8 * mm);
        const auto sag_m = [&](double dx, double dy) {
            return surface.sag_m(at_m.x + dx, at_m.y + dy).value();
        };
        const V3d expected = V3d(-(sag_m(h_m, 0.0) - sag_m(-h_m, 0.0)) / (2.0 * h_m),
                                 -(sag_m(0.0, h_m) - sag_m(0.0, -h_m)) / (2.0 * h_m), 1.0)
                                 .normalized();
        const V3d normal = surface.normal({at_m.x, at_m.y, surface.vertex_m + sag_m(0.0, 0.0)});
        EXPECT_NEAR((normal - expected).length(), 0.0, 1e-9);
    }
}

TEST(ConicSurface, the_other_sheet_of_a_hyperboloid_is_not_hit)
{
    // Its second sheet has its vertex at 2 R / (1 + Q) = -3.68 mm, where a ray from before the eye
    // passes first.
    const auto lens = ConicSurface::of_revolution(0.0, 12.0 * mm, -7.518749);
    const V3d direction = V3d(0.1, 0.0, 1.0).normalized();
    const auto hit_m = lens.intersection({{-1.0 * mm, 0.0, -10.0 * mm}, direction});
    ASSERT_TRUE(hit_m.has_value());
    EXPECT_GE(hit_m->z, 0.0);
    EXPECT_NEAR(hit_m->z, lens.sag_m(hit_m->x, hit_m->y).value(), 1e-17);
    // So steep that it gains on the vertex's sheet from before the vertex plane.
    const V3d steep = V3d(0.93, 0.0, 0.37).normalized();
    const auto far_hit_m = lens.intersection({{6.0 * mm, 0.0, 0.0}, steep});
    ASSERT_TRUE(far_hit_m.has_value());
    EXPECT_GT(far_hit_m->x, 6.0 * mm);
    EXPECT_NEAR(far_hit_m->z, lens.sag_m(far_hit_m->x, 0.0).value(), 1e-15);
}

TEST(ConicSurface, a_concave_retina_is_hit_beyond_its_equator_where_the_ray_leaves_the_eye)
{
    const auto retina = ConicSurface::of_revolution(24.0 * mm, -12.0 * mm, 0.0);
    const V3d from_m(0.0, 0.0, 7.0 * mm);
    const auto hit_m = retina.intersection({from_m, V3d(3.0, 0.0, 1.0).normalized()});
    ASSERT_TRUE(hit_m.has_value());
    EXPECT_NEAR((*hit_m - V3d(0.0, 0.0, 12.0 * mm)).length(), 12.0 * mm, 1e-16);
    EXPECT_GT(hit_m->x, 0.0);
    EXPECT_LT(hit_m->z, 12.0 * mm);
    EXPECT_FALSE(retina.is_on_vertex_side(*hit_m));
}

TEST(ConicSurface, rays_past_the_rim_miss)
{
    for (const ConicSurface& surface :
         {ConicSurface::of_revolution(0.0, 6.0 * mm, 0.0), toric_cornea()}) {
        EXPECT_FALSE(
            surface.intersection({{20.0 * mm, 0.0, -1.0 * mm}, {0.0, 0.0, 1.0}}).has_value());
        EXPECT_FALSE(surface.intersection({{0.0, 0.0, -1.0 * mm}, {1.0, 0.0, 0.0}}).has_value());
        EXPECT_FALSE(surface.sag_m(20.0 * mm, 0.0).has_value());
        EXPECT_FALSE(surface.intersection({{NAN, 0.0, 0.0}, {0.0, 0.0, 1.0}}).has_value());
    }
}

TEST(ConicSurface, a_biconic_of_equal_meridians_is_the_conic)
{
    const auto conic = ConicSurface::of_revolution(1.0 * mm, 7.72 * mm, -0.26);
    ConicSurface nearly = conic;
    nearly.conic_y = std::nextafter(conic.conic_y, 0.0);
    ASSERT_FALSE(nearly.is_of_revolution());
    const OpticalRay ray{{2.0 * mm, -3.0 * mm, -5.0 * mm}, V3d(0.2, 0.3, 1.0).normalized()};
    const V3d point_m = conic.intersection(ray).value();
    EXPECT_NEAR((nearly.intersection(ray).value() - point_m).length(), 0.0, 1e-17);
    EXPECT_NEAR((nearly.normal(point_m) - conic.normal(point_m)).length(), 0.0, 1e-14);
}

TEST(Refraction, obeys_snell_in_the_plane_of_incidence_whichever_way_the_normal_points)
{
    const V3d normal(0.0, 0.0, 1.0);
    const V3d direction(std::sin(0.5), 0.0, std::cos(0.5));
    for (const double sense : {1.0, -1.0}) {
        const V3d behind = refracted(direction, normal * sense, 1.0 / 1.376).value();
        EXPECT_NEAR(behind.x, std::sin(0.5) / 1.376, 1e-15);
        EXPECT_NEAR(behind.y, 0.0, 1e-15);
        EXPECT_NEAR(behind.length(), 1.0, 1e-15);
        EXPECT_GT(behind.z, 0.0);
    }
}

TEST(Refraction, is_total_beyond_the_critical_angle)
{
    const double critical_rad = std::asin(1.0 / 1.376);
    const auto at = [](double angle_rad) {
        return refracted({std::sin(angle_rad), 0.0, std::cos(angle_rad)}, {0.0, 0.0, 1.0}, 1.376);
    };
    EXPECT_TRUE(at(critical_rad - 1e-6).has_value());
    EXPECT_FALSE(at(critical_rad + 1e-6).has_value());
}

}  // namespace
}  // namespace eye_render
