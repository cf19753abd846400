// The path tracer against derived answers.

#include "base/units.h"
#include "estimate.h"
#include "scene_graphs.h"
#include "scenes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::Estimate;
using test::estimate;
using test::expect_matches;

TEST(Integrator, point_lamp_lights_a_plane_by_the_inverse_square)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0), test::diffuse(0.6f));
    data.lamps.push_back(test::point_lamp(V3d(1.0, 0.0, -1.0), 100.0f));
    const Scene scene(data, V3d(0.0));
    // Irradiance P / (4 pi^2) cos / d^2: Blender's watt of a point lamp is 1 / pi of a radiant
    // one.
    const double d2 = 1.0 + 4.0;
    const double irradiance = 100.0 / (4.0 * pi * pi) * (2.0 / std::sqrt(d2)) / d2;
    expect_matches(estimate(scene, {.max_bounces = 0}, {}, 16), 0.6 / pi * irradiance * pi);
}

TEST(Integrator, emissive_square_lights_a_plane_as_its_form_factor_says)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0), test::diffuse(0.5f));
    test::place(data, test::square(0.5f), V3d(0.0, 0.0, -2.0), test::emissive_diffuse(0.0f, 4.0f));
    const Scene scene(data, V3d(0.0));
    // The ray meets the plane below the square's edge, where half of it counts by symmetry; the
    // point-to-rectangle form factor of Howell's catalogue (B-4), rectangle a x b with one corner
    // above the point at distance c.
    const auto corner_factor = [](double a, double b, double c) {
        const double x = a / c;
        const double y = b / c;
        const double sx = std::sqrt(1 + x * x);
        const double sy = std::sqrt(1 + y * y);
        return (x / sx * std::atan(y / sx) + y / sy * std::atan(x / sy)) / (2 * pi);
    };
    // Seen point: (-0.9, 0, -3); the square spans x from -0.5 to 0.5, so 0.4 to 1.4 beside it.
    const double factor = 2.0 * (corner_factor(1.4, 0.5, 1.0) - corner_factor(0.4, 0.5, 1.0));
    const Ray ray{.direction = V3f(-0.9f, 0.0f, -3.0f).normalized()};
    expect_matches(estimate(scene, {.max_bounces = 0}, ray, 20000), 0.5 * 4.0 * factor);
}

TEST(Integrator, shadow_side_of_an_opaque_square_is_black)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0), test::diffuse(0.5f));
    test::place(data, test::square(0.4f), V3d(0.5, 0.0, -2.5), test::diffuse(0.5f));
    data.lamps.push_back(test::point_lamp(V3d(1.0, 0.0, -2.0), 100.0f));
    const Scene scene(data, V3d(0.0));
    EXPECT_EQ(estimate(scene, {.max_bounces = 0}, {}, 16).mean, 0.0);
}

TEST(Integrator, half_transparent_square_lets_half_of_the_light_pass)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0), test::diffuse(0.5f));
    data.lamps.push_back(test::point_lamp(V3d(1.0, 0.0, -2.0), 100.0f));
    const Scene open(data, V3d(0.0));
    const double without = estimate(open, {.max_bounces = 0}, {}, 16).mean;
    test::place(data, test::square(0.4f), V3d(0.5, 0.0, -2.5), test::transparent(0.5f));
    const Scene veiled(data, V3d(0.0));
    expect_matches(estimate(veiled, {.max_bounces = 0}, {}, 16), 0.5 * without);
}

TEST(Integrator, a_clear_sheet_changes_nothing_at_any_bounce)
{
    for (const int max_bounces : {0, 1, 4}) {
        SceneData data;
        test::place(data, test::square(2.0f), V3d(0.0, 0.0, -2.0), test::diffuse(0.5f));
        test::place(data, test::square(50.0f), V3d(0.0, 0.0, -1.0), test::transparent(1.0f));
        data.world = test::even_world(1.0f);
        const Scene scene(data, V3d(0.0));
        SCOPED_TRACE(max_bounces);
        expect_matches(estimate(scene, {.max_bounces = max_bounces}, {}, 4000), 0.5);
    }
}

TEST(Integrator, thin_plate_close_to_a_far_lamp_casts_its_shadow)
{
    for (const double distance : {10.0, 100.0, 1000.0}) {
        SceneData data;
        test::place(data, test::square(1.0f), V3d(0.0, 0.0, -distance), test::diffuse(0.5f));
        test::place(data, test::square(0.5f), V3d(0.0, 3.0, -0.002 * distance / 100.0),
                    test::diffuse(0.5f));
        data.lamps.push_back(test::point_lamp(V3d(0.0, 3.0, 0.0), 100.0f));
        const Scene scene(data, V3d(0.0));
        EXPECT_EQ(estimate(scene, {.max_bounces = 0}, {}, 16).mean, 0.0) << distance;
    }
}

TEST(Integrator, lamp_without_shadows_shines_through_on_a_glossy_floor)
{
    const Material glossy =
        plain_material("BSDF_GLOSSY", {{"Color", V3f(0.8f)}, {"Roughness", V3f(0.4f)}});
    const auto seen = [&glossy](bool is_blocked, bool casts_shadow) {
        SceneData data;
        test::place(data, test::square(5.0f), V3d(0.0, 0.0, -3.0), glossy);
        LampData lamp = test::point_lamp(V3d(0.2, 0.0, 0.5), 100.0f);
        lamp.settings.radius = 0.3f;
        lamp.settings.casts_shadow = casts_shadow;
        data.lamps.push_back(lamp);
        if (is_blocked) {
            test::place(data, test::square(1.0f), V3d(0.2, 1.2, -1.0), test::diffuse(0.0f));
            test::place(data, test::square(0.5f), V3d(0.6, 0.0, -0.5), test::diffuse(0.0f));
        }
        const Scene scene(data, V3d(0.0));
        return estimate(scene, {.max_bounces = 0}, {}, 40000);
    };
    const Estimate open = seen(false, true);
    const Estimate through = seen(true, false);
    EXPECT_NEAR(through.mean, open.mean, 4.0 * (through.standard_error + open.standard_error));
    EXPECT_LT(seen(true, true).mean, 0.5 * open.mean);
}

TEST(Integrator, tilted_plane_of_any_size_does_not_shadow_itself)
{
    for (const float size : {1.0f, 1e3f, 1e4f}) {
        for (const bool is_instanced : {false, true}) {
            SceneData data;
            test::place(data, test::square(size), V3d(0.0), test::diffuse(0.5f));
            M44d tilted;
            tilted.rotate(V3d(0.5, 0.3, 0.2));
            M44d at;
            at.setTranslation(V3d(0.0, 0.0, -2.0));
            data.instances[0].world_from_object = tilted * at;
            if (is_instanced) {
                InstanceData elsewhere = data.instances[0];
                elsewhere.world_from_object[3][1] = 1e6;
                data.instances.push_back(elsewhere);
            }
            LampData sun = test::point_lamp(V3d(0.0), 1.0f);
            sun.settings.kind = LampKind::Sun;
            data.lamps.push_back(sun);
            const Scene scene(data, V3d(0.0));
            // The sun shines along -Z on a plane whose normal's z is the cosine.
            V3d normal;
            tilted.multDirMatrix(V3d(0.0, 0.0, 1.0), normal);
            Estimate mean;
            for (int i = 0; i < 200; ++i) {
                const float x = 0.002f * static_cast<float>(i) - 0.2f;
                mean.mean += estimate(scene, {.max_bounces = 0},
                                      {.direction = V3f(x, 0.3f * x, -1.0f).normalized()}, 1)
                                 .mean /
                             200.0;
            }
            EXPECT_NEAR(mean.mean, 0.5 / pi * normal.z, 1e-4) << size << ' ' << is_instanced;
        }
    }
}

TEST(Integrator, transparent_film_leaves_the_world_out_and_keeps_coverage)
{
    SceneData data;
    test::place(data, test::square(0.5f), V3d(0.0, 0.0, -3.0), test::diffuse(0.5f));
    data.world = test::even_world(1.0f);
    const Scene scene(data, V3d(0.0));
    const IntegratorSettings settings{.film_transparent = true};
    SampleSequence hit_sequence(1, 0);
    EXPECT_EQ(trace_path(scene, settings, {}, hit_sequence).alpha, 1.0f);
    SampleSequence miss_sequence(1, 0);
    const PathRadiance missed =
        trace_path(scene, settings, {.direction = V3f(0, 1, 0)}, miss_sequence);
    EXPECT_EQ(missed.alpha, 0.0f);
    EXPECT_EQ(missed.radiance, Color3f(0.0f));
}

TEST(Integrator, transparent_film_shows_through_glass_as_smooth_as_asked_for)
{
    const auto behind = [](float roughness, float ior, float clear_alpha_squared) {
        SceneData data;
        test::place(data, test::square(5.0f), V3d(0.0, 0.0, -3.0),
                    plain_material("BSDF_GLASS", {{"Color", V3f(1.0f, 0.6f, 0.5f)},
                                                  {"Roughness", V3f(roughness)},
                                                  {"IOR", V3f(ior)}}));
        data.world = test::even_world(1.0f);
        const Scene scene(data, V3d(0.0));
        SampleSequence sequence(1, 0);
        return trace_path(scene,
                          {.film_transparent = true, .clear_alpha_squared = clear_alpha_squared},
                          {}, sequence);
    };
    // Of index 1 it takes and turns nothing.
    EXPECT_EQ(behind(0.0f, 1.0f, -1.0f).alpha, 1.0f);
    EXPECT_EQ(behind(0.0f, 1.0f, -1.0f).radiance, Color3f(1.0f, 0.6f, 0.5f));
    // What the colour takes away covers, as the mean of its channels.
    EXPECT_NEAR(behind(0.0f, 1.0f, 0.0f).alpha, 0.3f, 1e-6f);
    EXPECT_EQ(behind(0.0f, 1.0f, 0.0f).radiance, Color3f(0.0f));
    const auto to_the_fourth = [](float x) { return x * x * x * x; };
    EXPECT_LT(behind(0.3f, 1.3f, to_the_fourth(0.31f)).alpha, 0.5f);
    EXPECT_EQ(behind(0.3f, 1.3f, to_the_fourth(0.29f)).alpha, 1.0f);
}

// A floor of the material at z = -3 that only a panel over it lights; seen from between the two.
Estimate below_a_panel(const Material& floor, const Visibility& panel)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0), floor);
    test::place(data, test::square(0.5f), V3d(0.0, 0.0, 1.0), test::emission(4.0f));
    data.instances[1].visibility = panel;
    return estimate(Scene(data, V3d(0.0)), {.max_bounces = 1}, {}, 4000);
}

TEST(Integrator, panel_lights_only_the_kinds_of_scattering_that_see_it)
{
    const Material rough = plain_material("BSDF_GLOSSY", {{"Roughness", V3f(0.5f)}});
    const Visibility not_diffuse{.to_diffuse = false};
    const Visibility not_glossy{.to_glossy = false};
    EXPECT_EQ(below_a_panel(test::diffuse(0.5f), not_diffuse).mean, 0.0);
    EXPECT_EQ(below_a_panel(rough, not_glossy).mean, 0.0);
    EXPECT_EQ(below_a_panel(test::diffuse(0.5f), not_glossy).mean,
              below_a_panel(test::diffuse(0.5f), {}).mean);
    EXPECT_EQ(below_a_panel(rough, not_diffuse).mean, below_a_panel(rough, {}).mean);
}

// A sheet of the closure at z = -3 in a world of radiance 1, seen from the origin.
Estimate in_a_world(const std::string& closure, const Visibility& world)
{
    SceneData data;
    test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0),
                plain_material(closure, {{"Color", V3f(0.5f)}}));
    data.world = test::even_world(1.0f);
    data.world_visibility = world;
    return estimate(Scene(data, V3d(0.0)), {.max_bounces = 2}, {}, 4000);
}

TEST(Integrator, world_lights_only_the_kinds_of_scattering_that_see_it)
{
    expect_matches(in_a_world("BSDF_DIFFUSE", {}), 0.5);
    EXPECT_EQ(in_a_world("BSDF_DIFFUSE", {.to_diffuse = false}).mean, 0.0);
    expect_matches(in_a_world("BSDF_DIFFUSE", {.to_glossy = false}), 0.5);
    expect_matches(in_a_world("BSDF_GLASS", {.to_glossy = false, .to_transmission = false}), 0.0);
}

TEST(Integrator, hidden_world_is_not_in_the_picture)
{
    SceneData data;
    data.world = test::even_world(1.0f);
    data.world_visibility.to_camera = false;
    EXPECT_EQ(estimate(Scene(data, V3d(0.0)), {}, {}, 1).mean, 0.0);
}

// Light that a wide lobe lets pass: to a lamp or the world it is diffuse, to an object that is to
// be seen it is transmission. Light sampling and scattered rays agree on it.
TEST(Integrator, translucent_sheet_sees_lights_as_diffuse_and_objects_as_transmission)
{
    const Visibility not_diffuse{.to_diffuse = false};
    const Visibility not_transmission{.to_transmission = false};
    EXPECT_EQ(in_a_world("BSDF_TRANSLUCENT", not_diffuse).mean, 0.0);
    expect_matches(in_a_world("BSDF_TRANSLUCENT", not_transmission), 0.5);
    const auto before_a_panel = [](const Visibility& panel) {
        SceneData data;
        test::place(data, test::square(10.0f), V3d(0.0, 0.0, -3.0),
                    plain_material("BSDF_TRANSLUCENT", {{"Color", V3f(0.5f)}}));
        test::place(data, test::square(2.0f), V3d(0.0, 0.0, -4.0), test::emission(4.0f));
        data.instances[1].visibility = panel;
        return estimate(Scene(data, V3d(0.0)), {.max_bounces = 1}, {}, 4000).mean;
    };
    EXPECT_EQ(before_a_panel(not_transmission), 0.0);
    EXPECT_EQ(before_a_panel(not_diffuse), before_a_panel({}));
    EXPECT_GT(before_a_panel({}), 0.5);
}

TEST(Integrator, alpha_of_a_sum_of_closures_averages_to_what_is_covered)
{
    // All that is behind shows, and as much is mirrored: the mixture is sampled half and half.
    NodeGraph graph;
    const std::size_t clear = graph.add("BSDF_TRANSPARENT");
    const std::size_t mirror = graph.add("BSDF_GLOSSY");
    const std::size_t both = graph.add("ADD_SHADER");
    graph.set(clear, "Color", V3f(1.0f));
    graph.set(mirror, "Color", V3f(1.0f));
    graph.link(both, "Shader", graph.output(clear, "BSDF"));
    graph.link(both, "Shader_001", graph.output(mirror, "BSDF"));
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0.0, 0.0, -3.0),
                test::made(data, graph, graph.output(both, "Shader")));
    const Scene scene(data, V3d(0.0));
    const Estimate alpha = test::mean_of(4000, [&](int i) {
        SampleSequence sequence = test::sequence_of(i);
        return static_cast<double>(
            trace_path(scene, {.film_transparent = true}, {}, sequence).alpha);
    });
    EXPECT_NEAR(alpha.mean, 0.0, 4.0 * alpha.standard_error + 1e-6);
}

TEST(Integrator, ray_length_goes_on_behind_what_is_clear)
{
    NodeGraph graph;
    const std::size_t path = graph.add("LIGHT_PATH");
    const std::size_t glow = graph.add("EMISSION");
    graph.link(glow, "Strength", graph.output(path, "Ray Length"));
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0.0, 0.0, -1.0), test::transparent(1.0f));
    test::place(data, test::square(5.0f), V3d(0.0, 0.0, -2.5),
                test::made(data, graph, graph.output(glow, "Emission")));
    expect_matches(estimate(Scene(data, V3d(0.0)), {}, {}, 1), 2.5);
}

TEST(Integrator, length_of_a_shadow_ray_goes_on_behind_what_is_clear)
{
    NodeGraph graph;
    const std::size_t path = graph.add("LIGHT_PATH");
    const std::size_t tenth = graph.add("MATH", test::options_of({{"operation", "DIVIDE"}}));
    const std::size_t sheet = graph.add("BSDF_TRANSPARENT");
    graph.link(tenth, "Value", graph.output(path, "Ray Length"));
    graph.set(tenth, "Value_001", V3f(10.0f));
    graph.link(sheet, "Color", graph.output(tenth, "Value"));
    SceneData data;
    test::place(data, test::square(5.0f), V3d(0.0, 0.0, -1.0), test::transparent(1.0f));
    test::place(data, test::square(5.0f), V3d(0.0, 0.0, -2.5),
                test::made(data, graph, graph.output(sheet, "BSDF")));
    const Scene scene(data, V3d(0.0));
    // The ray goes on a little off the first sheet.
    EXPECT_NEAR(scene.transmittance({}).x, 0.25f, 1e-5f);
}

}  // namespace
}  // namespace eye_render
