// Lamps whose light is multiplied by nodes: what the nodes see, and that sampling and meeting a
// lamp agree.

#include "scene/scene.h"

#include "base/sobol.h"
#include "base/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace eye_render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

class AnyResources final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string&) override { return 0; }
    [[nodiscard]] int attribute(const std::string&) override { return 0; }
    void require_texture(int) override {}
    [[nodiscard]] WorkingSpace working_space() override { return WorkingSpace::Rec709; }
};

// Shines with what that output of the node says.
Material showing(std::string_view kind, std::string_view output)
{
    NodeGraph graph;
    const std::size_t emission = graph.add("EMISSION");
    graph.link(emission, "Color", graph.output(graph.add(kind), output));
    AnyResources resources;
    return make_material("nodes", graph, {.surface = graph.output(emission, "Emission")},
                         resources);
}

LampData lamp_at(const V3d& position, const LampSettings& settings, Material nodes)
{
    LampData lamp{.name = "lamp", .settings = settings, .world_from_light = {}};
    lamp.world_from_light.setTranslation(position);
    lamp.nodes = std::move(nodes);
    return lamp;
}

// The only lamp's light at the origin, as far as u says.
std::optional<IncomingLight> light_of(const LampData& lamp, const V2f& u = V2f(0.5f))
{
    SceneData data;
    data.lamps.push_back(lamp);
    const Scene scene(data, V3d(0.0));
    LitPoint point;
    scene.weigh_lights(V3f(0.0f), V3f(0.0f), point);
    return scene.sample_light(point, 0.5, u);
}

TEST(LampNodes, multiply_the_light_of_the_lamp)
{
    const LampSettings settings{.color = Color3f(100.0f)};
    const LampData plain{.name = "lamp",
                         .settings = settings,
                         .world_from_light = M44d().setTranslation(V3d(0, 0, 2))};
    const LampData dressed =
        lamp_at({0, 0, 2}, settings,
                plain_material("EMISSION", {{"Color", V3f(1, 0.5f, 0)}, {"Strength", V3f(4)}}));
    const auto without = light_of(plain);
    const auto with = light_of(dressed);
    ASSERT_TRUE(without && with);
    EXPECT_NEAR(with->radiance.x, 4.0f * without->radiance.x, 1e-5f);
    EXPECT_NEAR(with->radiance.y, 2.0f * without->radiance.y, 1e-5f);
    EXPECT_EQ(with->radiance.z, 0.0f);
}

TEST(LampNodes, see_directions_of_the_lamp_and_places_of_it)
{
    const V3d place(1, -2, 4);
    const LampSettings settings{.color = Color3f(100.0f)};
    const V3f wi = V3f(place).normalized();
    const float intensity = 100.0f / (4.0f * float(pi) * 21.0f);
    // Incoming points to what is lit; negative parts take light away.
    const auto incoming = light_of(lamp_at(place, settings, showing("NEW_GEOMETRY", "Incoming")));
    ASSERT_TRUE(incoming);
    EXPECT_NEAR(incoming->radiance.x, -wi.x * intensity, 1e-5f);
    EXPECT_NEAR(incoming->radiance.y, -wi.y * intensity, 1e-5f);
    const auto position = light_of(lamp_at(place, settings, showing("NEW_GEOMETRY", "Position")));
    ASSERT_TRUE(position);
    EXPECT_NEAR(position->radiance.x, 1.0f * intensity, 1e-5f);
    EXPECT_NEAR(position->radiance.z, 4.0f * intensity, 1e-5f);
    // The lamp's own directions: turned by a quarter about z, its x axis points along y.
    LampData turned = lamp_at(place, settings, showing("TEX_COORD", "Normal"));
    M44d turn;
    turn.setAxisAngle(V3d(0, 0, 1), 0.5 * pi);
    turned.world_from_light = turn * turned.world_from_light;
    const auto normal = light_of(turned);
    ASSERT_TRUE(normal);
    EXPECT_NEAR(normal->radiance.x, -wi.y * intensity, 1e-5f);
}

// Blender 4.3.2 and 5.2.2 show so.
TEST(LampNodes, see_their_own_coordinates_or_as_before_blender_4_4_the_worlds)
{
    LampSettings settings{.color = Color3f(1000.0f)};
    const auto red = [&](std::string_view kind, std::string_view output) {
        const auto light = light_of(lamp_at({1, 2, 4}, settings, showing(kind, output)));
        return light ? light->radiance.x / (1000.0f / (4.0f * float(pi) * 21.0f)) : 0.0f;
    };
    EXPECT_NEAR(red("TEX_COORD", "Object"), 0.0f, 1e-5f);
    EXPECT_NEAR(red("TEX_COORD", "Generated"), 0.0f, 1e-5f);
    EXPECT_NEAR(red("OBJECT_INFO", "Location"), 1.0f, 1e-5f);
    settings.has_own_space = false;
    EXPECT_NEAR(red("TEX_COORD", "Object"), 1.0f, 1e-5f);
    EXPECT_NEAR(red("TEX_COORD", "Generated"), 1.0f, 1e-5f);
    EXPECT_NEAR(red("OBJECT_INFO", "Location"), 0.0f, 1e-5f);
}

TEST(LampNodes, length_of_the_ray_is_the_distance_so_that_falloff_can_be_undone)
{
    const auto constant_at = [](double distance) {
        const auto light = light_of(lamp_at({0, 0, distance}, {.color = Color3f(10.0f)},
                                            showing("LIGHT_FALLOFF", "Constant")));
        return light ? light->radiance.x : 0.0f;
    };
    EXPECT_GT(constant_at(1.0), 0.0f);
    EXPECT_NEAR(constant_at(7.0), constant_at(1.0), 1e-4f * constant_at(1.0));
}

// Rectangle, disk, sphere, facing disk, spots and the sun, with UVs as their light.
std::vector<LampData> extended_lamps()
{
    std::vector<LampData> lamps;
    const auto add = [&](LampSettings settings) {
        settings.color = Color3f(10.0f);
        lamps.push_back(lamp_at({0.3, -0.2, 2.0}, settings, showing("TEX_COORD", "UV")));
    };
    add({.kind = LampKind::Area, .size_x = 1.0f, .size_y = 0.5f});
    add({.kind = LampKind::Area, .shape = LampShape::Disk, .size_x = 1.0f, .size_y = 0.5f});
    add({.radius = 0.4f, .soft_falloff = false});
    add({.radius = 0.4f});
    add({.kind = LampKind::Spot, .radius = 0.1f, .spot_angle_rad = 1.0f});
    add({.kind = LampKind::Sun, .angle_rad = 0.3f});
    return lamps;
}

TEST(LampNodes, sampled_light_is_what_a_ray_meets_there)
{
    for (const LampData& lamp : extended_lamps()) {
        SceneData data;
        data.lamps.push_back(lamp);
        const Scene scene(data, V3d(0.0));
        LitPoint point;
        scene.weigh_lights(V3f(0.0f), V3f(0.0f), point);
        int met = 0;
        for (std::uint32_t i = 0; i < 64; ++i) {
            const auto u = sobol_4d(4, i, 0);
            const auto light = scene.sample_light(point, u[2], V2f(u[0], u[1]));
            if (!light) {
                continue;
            }
            const PathState diffuse{.is_camera = false, .is_diffuse = true, .depth = 1};
            scene.visit_lamps(
                point, diffuse, light->wi, 0.0f, infinity, [&](const LampContribution& found) {
                    ++met;
                    // UVs of a disk seen at an angle, in float.
                    EXPECT_NEAR(found.radiance.x, light->radiance.x, 2e-3f * light->radiance.x);
                    EXPECT_NEAR(found.radiance.y, light->radiance.y, 2e-3f * light->radiance.y);
                });
        }
        EXPECT_GT(met, 50) << int(lamp.settings.kind);
    }
}

TEST(LampNodes, lamps_are_chosen_by_what_their_nodes_make_of_them)
{
    // Alike but for their nodes: one is a hundred times as bright.
    SceneData data;
    const auto glow = [](float strength) {
        NodeGraph graph;
        const std::size_t emission = graph.add("EMISSION");
        const std::size_t falloff = graph.add("LIGHT_FALLOFF");
        graph.set(falloff, "Strength", V3f(strength));
        graph.link(emission, "Strength", graph.output(falloff, "Quadratic"));
        AnyResources resources;
        return make_material("glow", graph, {.surface = graph.output(emission, "Emission")},
                             resources);
    };
    data.lamps.push_back(lamp_at({1, 0, 2}, {.color = Color3f(1.0f)}, glow(1.0f)));
    data.lamps.push_back(lamp_at({-1, 0, 2}, {.color = Color3f(1.0f)}, glow(100.0f)));
    const Scene scene(data, V3d(0.0));
    LitPoint point;
    scene.weigh_lights(V3f(0.0f), V3f(0.0f), point);
    int bright = 0;
    for (int i = 0; i < 1000; ++i) {
        const auto light = scene.sample_light(point, (i + 0.5) / 1000.0, V2f(0.5f));
        bright += light && light->wi.x < 0.0f ? 1 : 0;
    }
    EXPECT_GT(bright, 950);
    EXPECT_LT(bright, 1000) << "the faint one is chosen, too";
}

// UV of the lamp as it is seen along wi from the origin.
V2f uv_seen(const LampSettings& settings, const M44d& world_from_light, const V3f& wi)
{
    LampSettings placed = settings;
    placed.world_from_light = M44f(world_from_light);
    const Lamp lamp = make_lamp(placed);
    const LampSpace space(world_from_light, true);
    const auto hit = lamp_hit(lamp, V3f(0.0f), wi, infinity);
    const LampSight sight{.wi = wi, .distance = hit ? hit->t : 2.0f};
    const SceneFrame frame;
    return LampAttributes(lamp, space, sight, frame).uv(HitAttributes::active_uv_layer);
}

TEST(LampNodes, uvs_lay_a_picture_on_an_area_lamp_and_on_the_cone_of_a_spot)
{
    const M44d above = M44d().setTranslation(V3d(0, 0, 2));
    const LampSettings area{
        .kind = LampKind::Area, .color = Color3f(1.0f), .size_x = 2.0f, .size_y = 1.0f};
    const V2f corner = uv_seen(area, above, V3f(0.99f, -0.49f, 2.0f).normalized());
    EXPECT_NEAR(corner.x, 0.995f, 1e-4f);
    EXPECT_NEAR(corner.y, 0.01f, 1e-4f);
    M44d mirrored;
    mirrored.setScale(V3d(1, -1, 1));
    EXPECT_NEAR(uv_seen(area, mirrored * above, V3f(0.99f, -0.49f, 2.0f).normalized()).y, 0.99f,
                1e-4f);
    // The edge of the cone is the edge of the picture: here at 30 degrees.
    const LampSettings spot{.kind = LampKind::Spot,
                            .color = Color3f(1.0f),
                            .spot_angle_rad = float(rad_from_deg(60.0))};
    const float edge = 2.0f * float(std::tan(rad_from_deg(30.0)));
    const V2f rim = uv_seen(spot, above, V3f(-edge, 0.0f, 2.0f).normalized());
    EXPECT_NEAR(rim.x, 1.0f, 1e-4f);
    EXPECT_NEAR(rim.y, 0.5f, 1e-4f);
}

TEST(LampNodes, lamp_hidden_from_a_kind_of_scattering_is_not_met_by_it)
{
    LampData lamp = extended_lamps().front();
    lamp.nodes.reset();
    lamp.settings.visibility = {.to_camera = false, .to_diffuse = false};
    SceneData data;
    data.lamps.push_back(lamp);
    const Scene scene(data, V3d(0.0));
    LitPoint point;
    scene.weigh_lights(V3f(0.0f), V3f(0.0f), point);
    const auto light = scene.sample_light(point, 0.5, V2f(0.5f));
    ASSERT_TRUE(light);
    const auto meets = [&](const PathState& path) {
        int met = 0;
        scene.visit_lamps(point, path, light->wi, 0.0f, infinity,
                          [&](const LampContribution&) { ++met; });
        return met == 1;
    };
    EXPECT_FALSE(meets({.is_camera = false, .is_diffuse = true}));
    EXPECT_TRUE(meets({.is_camera = false, .is_glossy = true}));
    EXPECT_TRUE(meets({.is_camera = false, .is_glossy = true, .is_transmission = true}));
    EXPECT_FALSE(meets({.is_camera = true}));
    const BsdfParts parts{
        .diffuse = Color3f(1.0f), .glossy = Color3f(2.0f), .transmission = Color3f(4.0f)};
    EXPECT_EQ(light->visibility.seen_part(parts, false, light->is_surface), Color3f(6.0f));
}

}  // namespace
}  // namespace eye_render
