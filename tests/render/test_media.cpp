// The path tracer in participating media, against closed forms and integrals by the midpoint rule.

#include "estimate.h"
#include "scene_graphs.h"
#include "scenes.h"

namespace eye_render {
namespace {

using test::estimate;
using test::expect_matches;

const Ray ahead{.direction = V3f(0.1f, -0.05f, -1.0f).normalized()};

Material absorbing(float extinction)
{
    return test::filled("VOLUME_ABSORPTION", {{"Color", V3f(0.0f)}, {"Density", V3f(extinction)}});
}

Material white_mist(const V3f& scattering, float g)
{
    return test::filled("VOLUME_COEFFICIENTS", {{"Absorption Coefficients", V3f(0.0f)},
                                                {"Scatter Coefficients", scattering},
                                                {"Anisotropy", V3f(g)}});
}

// How far the ray goes within a cube of half width `h` in front of it.
double chord(double h) { return 2.0 * h / std::abs(double(ahead.direction.z)); }

SceneData in_white_world()
{
    SceneData data;
    data.world = test::even_world(1.0f);
    return data;
}

// A ray goes on a little off the surface that it passed, which a dense medium can tell.
void expect_absorbed(const test::Estimate& found, double expected)
{
    EXPECT_NEAR(found.mean, expected, 3e-4 * expected);
}

// A scene full of the medium.
void fill(SceneData& data, const Material& medium) { data.world.volume = medium.volume; }

TEST(Media, white_mist_vanishes_in_a_white_world)
{
    // In each channel the sum over bounces is 1; red is another one of the three each time.
    for (const V3f& scattering :
         {V3f(0.3f, 1.0f, 4.0f), V3f(1.0f, 4.0f, 0.3f), V3f(4.0f, 0.3f, 1.0f)}) {
        for (const float g : {-0.4f, 0.0f, 0.8f}) {
            SceneData data = in_white_world();
            test::place(data, test::ball(1.0f, 16), V3d(0.0, 0.0, -3.0),
                        white_mist(scattering, g));
            const Scene scene(data, V3d(0.0));
            SCOPED_TRACE(testing::Message() << scattering << ", g " << g);
            expect_matches(estimate(scene, {.max_bounces = 200}, ahead, 20000), 1.0);
        }
    }
}

TEST(Media, absorbing_slab_follows_beer_and_lambert)
{
    for (const float extinction : {0.1f, 1.0f, 3.0f}) {
        SceneData data = in_white_world();
        test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0), absorbing(extinction));
        const Scene scene(data, V3d(0.0));
        expect_absorbed(estimate(scene, {.max_bounces = 0}, ahead, 4),
                        std::exp(-double(extinction) * chord(0.5)));
    }
}

TEST(Media, overlapping_and_nested_meshes_absorb_together)
{
    SceneData data = in_white_world();
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0), absorbing(0.4f));
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.4), absorbing(0.7f));
    test::place(data, test::cube(0.25f), V3d(0.0, 0.0, -2.0), absorbing(0.9f));
    const Scene scene(data, V3d(0.0));
    expect_absorbed(estimate(scene, {.max_bounces = 0}, ahead, 4),
                    std::exp(-(0.4 + 0.7) * chord(0.5) - 0.9 * chord(0.25)));
}

TEST(Media, eye_within_a_volume_sees_the_rest_of_it)
{
    SceneData data = in_white_world();
    test::place(data, test::cube(2.0f), V3d(0.0), absorbing(0.5f));
    // Beside the eye, and above it: it is in neither.
    test::place(data, test::cube(0.5f), V3d(0.0, 3.0, 0.0), absorbing(9.0f));
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, 1.0), absorbing(9.0f));
    const Scene scene(data, V3d(0.0));
    expect_absorbed(estimate(scene, {.max_bounces = 0}, ahead, 4), std::exp(-0.5 * chord(1.0)));
}

// Paths near the eye are in what the eye is in, without a look for it; farther away they look.
TEST(Media, what_a_path_starts_in_depends_on_its_place)
{
    for (const double z : {0.0, -0.9}) {
        SceneData data;
        test::place(data, test::ball(1.0f, 32), V3d(0.8 * (z < 0.0), 0.8 * (z < 0.0), z),
                    absorbing(1.0f));
        const Scene scene(data, V3d(0.0));
        const bool eye_is_within = z == 0.0;  // else in its box alone
        EXPECT_EQ(scene.media_at(V3f(0.0f)).in_medium(), eye_is_within);
        EXPECT_EQ(scene.media_at(V3f(0.01f, 0.0f, -0.1f)).in_medium(), eye_is_within);
        EXPECT_EQ(scene.media_at(V3f(0.0f, 0.0f, 1.1f)).in_medium(), false);
        EXPECT_EQ(scene.media_at(V3f(0.8f, 0.8f, -0.9f)).in_medium(), !eye_is_within);
        EXPECT_EQ(scene.media_at(V3f(0.0f, 0.5f, 0.5f)).in_medium(), eye_is_within);
    }
}

TEST(Media, world_behind_a_medium_without_end_is_not_seen)
{
    SceneData data = in_white_world();
    fill(data, absorbing(0.01f));
    EXPECT_EQ(estimate(Scene(data, V3d(0.0)), {.max_bounces = 2}, ahead, 4).mean, 0.0);
}

TEST(Media, mesh_that_is_not_closed_is_left_where_nothing_is_behind)
{
    SceneData data = in_white_world();
    test::place(data, test::square(1.0f), V3d(0.0, 0.0, -2.0), absorbing(1.0f));
    expect_matches(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4), 1.0);
}

TEST(Media, gas_glows_by_its_depth_less_what_it_absorbs)
{
    SceneData data;
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0),
                test::filled("EMISSION", {{"Color", V3f(1.0f)}, {"Strength", V3f(3.0f)}}));
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    3.0 * chord(0.5));
    test::place(data, test::cube(0.6f), V3d(0.0, 0.0, -2.0), absorbing(2.0f));
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    std::exp(-2.0 * chord(0.05)) * 3.0 / 2.0 *
                        (1.0 - std::exp(-2.0 * chord(0.5))));
}

TEST(Media, light_is_absorbed_on_its_way_to_a_surface_and_on_to_the_eye)
{
    SceneData data;
    test::place(data, test::square(4.0f), V3d(0.0, 0.0, -2.0), test::diffuse(1.0f));
    data.lamps.push_back(test::point_lamp(V3d(0.0), 100.0f));
    const double clear = estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4).mean;
    const double way = 2.0 / std::abs(double(ahead.direction.z));
    // Through a volume that does not reach the lamp; once for the shadow ray, once for the eye's.
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -1.0), absorbing(0.8f));
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    clear * std::exp(-2.0 * 0.8 * chord(0.5)));
    fill(data, absorbing(0.3f));
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    clear * std::exp(-2.0 * 0.8 * chord(0.5) - 2.0 * 0.3 * way));
}

TEST(Media, sun_does_not_reach_through_a_medium_without_end)
{
    SceneData data;
    test::place(data, test::square(4.0f), V3d(0.0, 0.0, -2.0), test::diffuse(1.0f));
    LampSettings sun{.kind = LampKind::Sun, .color = Color3f(1.0f)};
    data.lamps.push_back({.name = "sun", .settings = sun, .world_from_light = M44d()});
    EXPECT_GT(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4).mean, 0.1);
    fill(data, absorbing(0.01f));
    EXPECT_EQ(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4).mean, 0.0);
}

// Light of a lamp of fluence(p) scattered once towards the eye, along the whole ray.
template <typename Fluence>
double scattered_once(double scattering, double g, const V3d& lamp, const Fluence& fluence)
{
    const V3d along(ahead.direction);
    double sum = 0.0;
    constexpr double step = 1e-3;
    for (int i = 0; i < 100000; ++i) {
        const V3d p = along * ((i + 0.5) * step);
        const double cosine = along.dot((lamp - p).normalized());
        sum += scattering * std::exp(-scattering * (i + 0.5) * step) *
               fluence((lamp - p).length()) *
               double(phase_value({.g = float(g)}, float(1.0 - cosine))) * step;
    }
    return sum;
}

TEST(Media, light_of_a_point_is_scattered_once_as_the_integral_says)
{
    const V3d at(0.4, 0.3, -2.5);
    for (const double g : {0.0, 0.7, -0.5}) {
        for (const double scattering : {0.05, 1.0}) {
            SceneData data;
            data.lamps.push_back(test::point_lamp(at, 100.0f));
            fill(data, white_mist(V3f(float(scattering)), float(g)));
            // Radiant intensity of a point of P watts.
            const double expected = scattered_once(scattering, g, at, [&](double distance) {
                return 100.0 / (4.0 * std::numbers::pi) * std::exp(-scattering * distance) /
                       (distance * distance);
            });
            SCOPED_TRACE(testing::Message() << "g " << g << ", scattering " << scattering);
            const auto found = estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 20000);
            EXPECT_NEAR(found.mean, expected, 4.0 * found.standard_error + 1e-3 * expected);
            EXPECT_LT(found.standard_error, 0.02 * expected);  // what looking for the lamp is for
        }
    }
}

// A lamp that scattered rays may meet, too: weighing both ways counts it once.
TEST(Media, light_of_a_sphere_is_scattered_once_as_the_integral_says)
{
    constexpr double radius = 0.5;
    const V3d at(0.5, 0.6, -2.5);
    LampData lamp = test::point_lamp(at, 100.0f);
    lamp.settings.radius = radius;
    lamp.settings.soft_falloff = false;
    SceneData data;
    data.lamps.push_back(lamp);
    // So thin that nothing is lost on the way.
    constexpr double scattering = 1e-4;
    fill(data, white_mist(V3f(float(scattering)), 0.0f));
    const double radiance = 100.0 / (4.0 * std::pow(std::numbers::pi * radius, 2));
    const double expected = scattered_once(scattering, 0.0, at, [&](double distance) {
        const double cosine = std::sqrt(1.0 - std::pow(radius / distance, 2));
        return radiance * 2.0 * std::numbers::pi * (1.0 - cosine);
    });
    const auto found = estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 40000);
    EXPECT_NEAR(found.mean, expected, 4.0 * found.standard_error + 2e-3 * expected);
}

TEST(Media, panel_and_world_that_media_do_not_see_leave_them_dark)
{
    SceneData data = in_white_world();
    test::place(data, test::square(0.5f), V3d(0.0, 1.0, -2.0), test::emission(4.0f));
    test::place(data, test::ball(1.0f, 16), V3d(0.0, 0.0, -3.0), white_mist(V3f(1.0f), 0.0f));
    data.instances[0].visibility.to_volume_scatter = false;
    data.world_visibility = {.to_camera = false, .to_volume_scatter = false};
    EXPECT_EQ(estimate(Scene(data, V3d(0.0)), {.max_bounces = 4}, ahead, 2000).mean, 0.0);
}

TEST(Media, scattered_light_stops_at_the_last_bounce)
{
    SceneData data = in_white_world();
    test::place(data, test::ball(1.0f, 16), V3d(0.0, 0.0, -3.0), white_mist(V3f(2.0f), 0.0f));
    const Scene scene(data, V3d(0.0));
    double last = 0.0;
    for (const int max_bounces : {0, 1, 2, 8}) {
        const double seen = estimate(scene, {.max_bounces = max_bounces}, ahead, 20000).mean;
        EXPECT_GT(seen, last + 0.005) << max_bounces;
        last = seen;
    }
}

// Absorbs all colours alike, as densely as the graph's output says.
Material absorbing_by(SceneData& data, NodeGraph& graph, const NodeOutput& density)
{
    const std::size_t absorption = graph.add("VOLUME_ABSORPTION");
    graph.link(absorption, "Density", density);
    graph.set(absorption, "Color", V3f(0.0f));
    test::SceneNames names(data);
    return make_material("m", graph, {.volume = graph.output(absorption, "Volume")}, names);
}

// Along the middle a ramp of density absorbs as much as its mean.
TEST(Media, volume_that_varies_is_shown_as_its_mean)
{
    NodeGraph graph;
    const std::size_t place = graph.add("TEX_COORD");
    const std::size_t parts = graph.add("SEPXYZ");
    graph.link(parts, "Vector", graph.output(place, "Generated"));
    SceneData data = in_white_world();
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0),
                absorbing_by(data, graph, graph.output(parts, "Z")));
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    std::exp(-0.5 * chord(0.5)));
}

TEST(Media, objects_of_one_material_may_differ)
{
    NodeGraph graph;
    const std::size_t object = graph.add("OBJECT_INFO");
    SceneData data = in_white_world();
    const Material material = absorbing_by(data, graph, graph.output(object, "Object Index"));
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0), material);
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -4.0), material);
    data.instances[0].look.pass_index = 1.0f;
    data.instances[1].look.pass_index = 2.0f;
    expect_absorbed(estimate(Scene(data, V3d(0.0)), {.max_bounces = 0}, ahead, 4),
                    std::exp(-3.0 * chord(0.5)));
}

TEST(Media, scene_without_volumes_has_none)
{
    SceneData data = in_white_world();
    test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0), test::diffuse(0.5f));
    const Scene scene(data, V3d(0.0));
    EXPECT_FALSE(scene.has_media());
    EXPECT_FALSE(scene.media_at(V3f(0.0f)).in_medium());
}

}  // namespace
}  // namespace eye_render
