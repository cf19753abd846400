// The path tracer where light comes from all around: white things must vanish, and a closed box
// sums a geometric series.

#include "../shading/options_of.h"
#include "estimate.h"
#include "scenes.h"
#include "shading/energy_tables.h"

namespace eye_render {
namespace {

using test::Estimate;
using test::estimate;
using test::expect_matches;

// Of the albedo tables, as tests/shading/test_energy_tables.cpp and test_principled.cpp find it:
// what one meeting with a rough surface may gain or lose.
constexpr double table_error = 3e-3;

Material metal(float roughness, const char* distribution)
{
    return plain_material("BSDF_GLOSSY", {{"Color", V3f(1.0f)}, {"Roughness", V3f(roughness)}},
                          test::options_of({{"distribution", distribution}}));
}

Material glass(float roughness)
{
    return plain_material(
        "BSDF_GLASS", {{"Color", V3f(1.0f)}, {"Roughness", V3f(roughness)}, {"IOR", V3f(1.5f)}});
}

// In a world of radiance 1, before the eye. Flat facets: what interpolated normals lose is another
// matter.
SceneData ball_in_white_world(const Material& material)
{
    SceneData data;
    test::place(data, test::ball(1.0f, 24), V3d(0.0, 0.0, -3.0), material);
    data.world = test::even_world(1.0f);
    return data;
}

// From its middle to near its rim, where views are grazing.
std::vector<Ray> rays_to_ball()
{
    std::vector<Ray> rays;
    for (const float x : {0.05f, 0.5f, 0.8f, 0.95f}) {
        rays.push_back({.direction = V3f(x, 0.03f, -2.9f).normalized()});
    }
    return rays;
}

TEST(Furnace, closed_box_sums_the_geometric_series)
{
    constexpr float albedo = 0.7f;
    for (const int max_bounces : {0, 1, 3, 6}) {
        SceneData data;
        test::place(data, test::cube(1.0f), V3d(0.0), test::emissive_diffuse(albedo, 0.5f));
        const Scene scene(data, V3d(0.0));
        double expected = 0.0;
        for (int k = 0; k <= max_bounces + 1; ++k) {
            expected += 0.5 * std::pow(static_cast<double>(albedo), k);
        }
        SCOPED_TRACE(max_bounces);
        expect_matches(estimate(scene, {.max_bounces = max_bounces},
                                {.direction = V3f(0.3f, 0.2f, -1.0f).normalized()}, 20000),
                       expected);
    }
}

TEST(Furnace, closed_box_reaches_one_over_one_minus_albedo)
{
    for (const float albedo : {0.5f, 0.8f}) {
        SceneData data;
        test::place(data, test::cube(1.0f), V3d(0.0), test::emissive_diffuse(albedo, 1.0f));
        const Scene scene(data, V3d(0.0));
        SCOPED_TRACE(albedo);
        // 64 bounces leave out 0.8^66, 4e-7.
        expect_matches(estimate(scene, {.max_bounces = 64}, {}, 20000),
                       1.0 / (1.0 - static_cast<double>(albedo)));
    }
}

TEST(Furnace, white_surface_vanishes_in_a_white_world)
{
    SceneData data;
    test::place(data, test::square(1.0f), V3d(0.0, 0.0, -2.0), test::diffuse(1.0f));
    data.world = test::even_world(1.0f);
    const Scene scene(data, V3d(0.0));
    expect_matches(estimate(scene, {.max_bounces = 4}, {}, 4000), 1.0);
}

TEST(Furnace, white_metal_ball_vanishes_whatever_its_roughness)
{
    for (const float roughness : {0.3f, 0.7f, 1.0f}) {
        const SceneData data = ball_in_white_world(metal(roughness, "MULTI_GGX"));
        const Scene scene(data, V3d(0.0));
        for (const Ray& ray : rays_to_ball()) {
            const Estimate found = estimate(scene, {.max_bounces = 4}, ray, 10000);
            EXPECT_NEAR(found.mean, 1.0, 4.0 * found.standard_error + table_error)
                << "roughness " << roughness << ", direction " << ray.direction;
        }
    }
}

TEST(Furnace, metal_without_compensation_loses_what_single_scattering_loses)
{
    for (const float roughness : {0.3f, 0.7f, 1.0f}) {
        const SceneData data = ball_in_white_world(metal(roughness, "GGX"));
        const Scene scene(data, V3d(0.0));
        for (const Ray& ray : rays_to_ball()) {
            const auto hit = scene.intersect(ray);
            ASSERT_TRUE(hit);
            const LobeEnergy energy =
                reflection_energy(roughness, -hit->point.ng.dot(ray.direction));
            const Estimate found = estimate(scene, {.max_bounces = 4}, ray, 10000);
            EXPECT_NEAR(found.mean, static_cast<double>(energy.albedo),
                        4.0 * found.standard_error + table_error)
                << "roughness " << roughness << ", direction " << ray.direction;
        }
    }
}

TEST(Furnace, white_glass_ball_vanishes_whatever_its_roughness)
{
    // Even light that fills the ball evenly meets 2.5 times its surface from inside before it
    // leaves: 60 % of it is reflected at index 1.5. Once it came in.
    constexpr double meetings = 3.5;
    for (const float roughness : {0.0f, 0.3f, 0.7f, 1.0f}) {
        const SceneData data = ball_in_white_world(glass(roughness));
        const Scene scene(data, V3d(0.0));
        for (const Ray& ray : rays_to_ball()) {
            const Estimate found = estimate(scene, {.max_bounces = 128}, ray, 5000);
            EXPECT_NEAR(found.mean, 1.0, 4.0 * found.standard_error + meetings * table_error)
                << "roughness " << roughness << ", direction " << ray.direction;
        }
    }
}

}  // namespace
}  // namespace eye_render
