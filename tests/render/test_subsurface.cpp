// Subsurface scattering in the path tracer: what must vanish in a white world, what a medium
// inside a surface of other nodes shows as well, and its limits.

#include "../shading/options_of.h"
#include "estimate.h"
#include "render/subsurface.h"
#include "scene_graphs.h"
#include "scenes.h"
#include "shading/subsurface.h"

namespace eye_render {
namespace {

using test::Estimate;
using test::estimate;

constexpr const char* methods[] = {"RANDOM_WALK", "RANDOM_WALK_LEGACY", "RANDOM_WALK_SKIN",
                                   "BURLEY"};

Material below(const char* method, const V3f& color, const V3f& radius, float anisotropy = 0.0f)
{
    return plain_material("SUBSURFACE_SCATTERING",
                          {{"Color", color},
                           {"Scale", V3f(1.0f)},
                           {"Radius", radius},
                           {"Anisotropy", V3f(anisotropy)}},
                          test::options_of({{"falloff", method}}));
}

const Ray ahead{.direction = V3f(0.1f, -0.05f, -1.0f).normalized()};

SceneData ball_in_white_world(const Material& material)
{
    SceneData data;
    test::place(data, test::ball(1.0f, 24), V3d(0.0, 0.0, -3.0), material);
    data.world = test::even_world(1.0f);
    return data;
}

Estimate seen(const SceneData& data, int paths, int max_bounces = 1)
{
    return estimate(Scene(data, V3d(0.0)), {.max_bounces = max_bounces}, ahead, paths);
}

// Light that is not absorbed leaves somewhere. What is lost is a millionth at each collision, and
// walks of more than 256 flights.
TEST(Subsurface, white_ball_vanishes_in_a_white_world)
{
    // Light in white skin goes a six hundredth of the radius at a time.
    for (const auto& [method, radius] : {std::pair{"RANDOM_WALK", 0.1f},
                                         {"RANDOM_WALK_LEGACY", 1.0f},
                                         {"RANDOM_WALK_SKIN", 60.0f}}) {
        for (const float anisotropy : {0.0f, 0.8f}) {
            const SceneData data =
                ball_in_white_world(below(method, V3f(1.0f), V3f(radius), anisotropy));
            const Estimate found = seen(data, 10000);
            EXPECT_NEAR(found.mean, 1.0, 4.0 * found.standard_error + 2e-3)
                << method << ", anisotropy " << anisotropy;
            EXPECT_LT(found.standard_error, 0.02) << method << ", anisotropy " << anisotropy;
        }
    }
}

TEST(Subsurface, what_does_not_go_far_is_diffuse)
{
    const V3f color(0.7f);
    const Estimate diffuse =
        seen(ball_in_white_world(plain_material("BSDF_DIFFUSE", {{"Color", color}})), 4);
    for (const char* method : methods) {
        const Estimate none = seen(ball_in_white_world(below(method, color, V3f(0.0f))), 4);
        EXPECT_EQ(none.mean, diffuse.mean) << method;
    }
    // Skin's radius is another length. Van de Hulst's albedo is of light that enters from all
    // around; what is refracted on its way in goes deeper, and 0.04 of it is lost.
    struct Case {
        const char* method;
        float radius;
        double fit_error;
    };
    for (const auto& [method, radius, fit_error] : {Case{"RANDOM_WALK", 0.001f, 0.05},
                                                    {"RANDOM_WALK_LEGACY", 0.01f, 0.02},
                                                    {"BURLEY", 0.01f, 0.02}}) {
        const Estimate little =
            seen(ball_in_white_world(below(method, color, V3f(radius))), 20000);
        EXPECT_NEAR(little.mean, diffuse.mean, 4.0 * little.standard_error + fit_error) << method;
    }
}

// The walk's medium, in a surface that light enters straight ahead and leaves as from a Lambert
// one, made of other nodes.
Material medium_behind_lambert(SceneData& data, const SubsurfaceMedium& medium)
{
    NodeGraph graph;
    const std::size_t geometry = graph.add("NEW_GEOMETRY");
    const std::size_t mix = graph.add("MIX_SHADER");
    const std::size_t clear = graph.add("BSDF_TRANSPARENT");
    const std::size_t lambert = graph.add("BSDF_TRANSLUCENT");
    graph.set(lambert, "Color", V3f(1.0f));
    graph.link(mix, "Fac", graph.output(geometry, "Backfacing"));
    graph.link(mix, "Shader", graph.output(clear, "BSDF"));
    graph.link(mix, "Shader_001", graph.output(lambert, "BSDF"));
    const std::size_t volume = graph.add("VOLUME_COEFFICIENTS");
    graph.set(volume, "Scatter Coefficients", medium.extinction * medium.albedo);
    graph.set(volume, "Absorption Coefficients",
              medium.extinction * (Color3f(1.0f) - medium.albedo));
    graph.set(volume, "Anisotropy", V3f(medium.anisotropy));
    test::SceneNames names(data);
    return make_material(
        "m", graph,
        {.surface = graph.output(mix, "Shader"), .volume = graph.output(volume, "Volume")}, names);
}

void light_from_behind(SceneData& data)
{
    LampSettings sun{.kind = LampKind::Sun, .color = Color3f(3.0f)};
    M44d world_from_light;
    world_from_light.rotate(V3d(2.6, 0.4, 0.0));
    data.lamps.push_back({.name = "sun", .settings = sun, .world_from_light = world_from_light});
}

TEST(Subsurface, walk_is_that_of_a_medium_behind_a_lambert_surface)
{
    for (const float anisotropy : {0.0f, 0.6f}) {
        const V3f color(0.8f, 0.5f, 0.9f);
        const V3f radius(5.0f, 9.0f, 2.0f);
        const Material walk =
            plain_material("SUBSURFACE_SCATTERING", {{"Color", color},
                                                     {"Scale", V3f(1.0f)},
                                                     {"Radius", radius},
                                                     {"IOR", V3f(1.0f)},  // brought to 1.01
                                                     {"Roughness", V3f(0.0f)},
                                                     {"Anisotropy", V3f(anisotropy)}});
        Lobe lobe = plain_lobe(LobeKind::RandomWalk, Color3f(1.0f), V3f(0.0f, 0.0f, 1.0f));
        lobe.f0 = color;
        lobe.edge = radius;
        lobe.a = anisotropy;
        SceneData data;
        test::place(data, test::cube(0.5f), V3d(0.0, 0.0, -2.0), walk);
        light_from_behind(data);
        SceneData apart;
        test::place(apart, test::cube(0.5f), V3d(0.0, 0.0, -2.0),
                    medium_behind_lambert(apart, subsurface_medium(lobe)));
        light_from_behind(apart);
        const Estimate found = seen(data, 20000);
        const Estimate expected = seen(apart, 20000, 400);
        EXPECT_GT(expected.mean, 0.01);
        // Of the index: 1 %, by which the way of what enters is bent.
        EXPECT_NEAR(found.mean, expected.mean,
                    4.0 * std::hypot(found.standard_error, expected.standard_error) +
                        0.01 * expected.mean)
            << "anisotropy " << anisotropy;
    }
}

// Each colour of light at its own distance: none is darker or lighter for the others.
TEST(Subsurface, channels_are_walked_together_as_each_alone)
{
    const V3f color(0.8f);
    const Estimate alone = seen(ball_in_white_world(below(methods[0], color, V3f(0.5f))), 15000);
    const Estimate together =
        seen(ball_in_white_world(below(methods[0], color, V3f(0.5f, 8.0f, 0.05f))), 15000);
    EXPECT_NEAR(together.mean, alone.mean,
                4.0 * std::hypot(alone.standard_error, together.standard_error));
}

TEST(Subsurface, is_finite_and_absorbs_whatever_the_radius)
{
    for (const char* method : methods) {
        for (const float radius : {0.0f, 1e-30f, 1e-6f, 1e-3f, 1e3f, 1e12f, -1.0f}) {
            for (const float anisotropy : {-1.0f, 0.0f, 0.5f, 1.0f}) {
                for (const float color : {0.0f, 1e-4f, 0.02f, 0.5f, 1.0f}) {
                    const SceneData data = ball_in_white_world(
                        below(method, V3f(color), V3f(radius, 0.1f, radius), anisotropy));
                    const Estimate found = seen(data, 16);
                    EXPECT_TRUE(std::isfinite(found.mean) && found.mean >= 0.0 &&
                                found.mean < 1.0 + 4.0 * found.standard_error + 1e-3)
                        << method << ", radius " << radius << ", anisotropy " << anisotropy
                        << ", color " << color << ": " << found.mean;
                }
            }
        }
    }
}

// Nothing holds the light in a sheet: what does not come back is gone.
TEST(Subsurface, open_sheet_loses_light_and_ends)
{
    SceneData data;
    test::place(data, test::square(2.0f), V3d(0.0, 0.0, -2.0),
                below(methods[0], V3f(1.0f), V3f(1.0f)));
    data.world = test::even_world(1.0f);
    const Estimate found = seen(data, 20000);
    EXPECT_GT(found.mean, 0.5);
    EXPECT_LT(found.mean, 1.0);
}

TEST(Subsurface, other_objects_neither_stop_a_walk_nor_let_it_out)
{
    const Material material = below(methods[0], V3f(0.8f), V3f(4.0f));
    const SceneData alone = ball_in_white_world(material);
    SceneData full = ball_in_white_world(material);
    test::place(full, test::cube(0.3f), V3d(0.1, 0.0, -3.0), test::diffuse(0.0f));
    const Estimate expected = seen(alone, 15000);
    const Estimate found = seen(full, 15000);
    EXPECT_NEAR(found.mean, expected.mean,
                4.0 * std::hypot(found.standard_error, expected.standard_error));
}

// A bump, too, where light comes out.
TEST(Subsurface, light_leaves_around_the_normal_of_the_material_there)
{
    const V3f tilted(0.6f, 0.0f, 0.8f);
    SceneData data;
    test::place(data, test::square(2.0f), V3d(0.0, 0.0, -2.0),
                plain_material("SUBSURFACE_SCATTERING", {{"Normal", tilted}}));
    test::place(data, test::square(2.0f), V3d(0.0, 0.0, -3.0),
                plain_material("SUBSURFACE_SCATTERING", {}));
    const Scene scene(data, V3d(0.0));
    const auto bent = scene.intersect({});
    const auto plain = scene.intersect({.t_min = 2.5f});
    ASSERT_TRUE(bent && plain);
    EXPECT_TRUE(bent->material().surface.bends_subsurface());
    EXPECT_FALSE(plain->material().surface.bends_subsurface());
    const V3f up(0.0f, 0.0f, 1.0f);
    EXPECT_LT((exit_bsdf(scene, *bent, {}).mean_normal(up) - tilted).length(), 1e-5f);
    EXPECT_EQ(exit_bsdf(scene, *plain, {}).mean_normal(tilted), up);
}

// The first bounce hides what lies below from the second.
TEST(Subsurface, is_diffuse_in_what_a_diffuse_surface_is_lit_by)
{
    const ShadingPoint point{
        .wo = V3f(0.0f, 0.0f, 1.0f), .ng = V3f(0.0f, 0.0f, 1.0f), .ns = V3f(0.0f, 0.0f, 1.0f)};
    constexpr float nan = std::numeric_limits<float>::quiet_NaN();
    Bsdf direct(point.wo, point.ng);
    Bsdf indirect(point.wo, point.ng);
    const SubsurfaceInputs inputs{.radius = Color3f(1.0f, 0.0f, nan)};
    add_subsurface(direct, inputs, Color3f(0.8f), point.ng, point, false);
    add_subsurface(indirect, inputs, Color3f(0.8f), point.ng, point, true);
    EXPECT_EQ(direct.albedos().diffuse, Color3f(0.8f));
    EXPECT_FLOAT_EQ(direct.evaluate(point.ng).value.x, 0.0f);
    // The channels that go nowhere.
    EXPECT_GT(direct.evaluate(point.ng).value.y, 0.1f);
    EXPECT_GT(direct.evaluate(point.ng).value.z, 0.1f);
    EXPECT_GT(indirect.evaluate(point.ng).value.x, 0.1f);
    EXPECT_TRUE(direct.exit_lobe().has_value());
    EXPECT_FALSE(indirect.exit_lobe().has_value());
}

}  // namespace
}  // namespace eye_render
