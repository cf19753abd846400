// What bends the normal: maps in their spaces, and heights against the analytic normal of the
// surface that they lift. What Cycles makes of them on meshes is tested in
// tests/scene/test_nodes_beside_cycles.cpp.

#include "asked_node.h"
#include "scattering.h"
#include "shading/bump.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

using test::AskedNode;
using test::direction_at;
using test::GraphTrial;
using test::MadeUpHit;
using test::up;

constexpr float rounding = 2e-6f;
const ShadingPoint flat_point{.wo = direction_at(20.0), .ng = up, .ns = up};

V3f mapped(const V3f& map_normal,
           const ShadingPoint& point = flat_point,
           const MadeUpHit& hit = {},
           float strength = 1.0f,
           const char* space = "TANGENT")
{
    return AskedNode{.type = "NORMAL_MAP",
                     .options = {{"space", space}},
                     .inputs = {{"Color", (map_normal + V3f(1.0f)) * 0.5f},
                                {"Strength", V3f(strength)}}}("Normal", hit, point);
}

TEST(NormalMapNode, red_is_along_the_tangent_and_green_up_across_it)
{
    EXPECT_LT((mapped({0.6f, 0, 0.8f}) - V3f(0.6f, 0, 0.8f)).length(), rounding);
    EXPECT_LT((mapped({0, 0.6f, 0.8f}) - V3f(0, 0.6f, 0.8f)).length(), rounding);
}

TEST(NormalMapNode, a_mirrored_map_turns_green_over)
{
    MadeUpHit hit;
    hit.frame.bitangent_sign = -1.0f;
    EXPECT_LT((mapped({0, 0.6f, 0.8f}, flat_point, hit) - V3f(0, -0.6f, 0.8f)).length(), rounding);
}

TEST(NormalMapNode, smoothed_tangents_of_the_mesh_come_before_the_triangles)
{
    MadeUpHit hit;
    hit.smoothed_tangent = {.value = Color4f(0.0f, 2.0f, 0.0f, -1.0f), .exists = true};
    EXPECT_LT((mapped({0.6f, 0, 0.8f}, flat_point, hit) - V3f(0, 0.6f, 0.8f)).length(), rounding);
    // B = -cross(N, T) is along +x.
    EXPECT_LT((mapped({0, 0.6f, 0.8f}, flat_point, hit) - V3f(0.6f, 0, 0.8f)).length(), rounding);
    hit.facts.world_from_object.setScale(V3f(-1, 1, 1));
    hit.facts.object_from_world = hit.facts.world_from_object.inverse();
    EXPECT_LT((mapped({0, 0.6f, 0.8f}, flat_point, hit) - V3f(-0.6f, 0, 0.8f)).length(), rounding)
        << "what is mirrored is the object, with its map";
}

TEST(NormalMapNode, strength_below_zero_turns_bumps_into_hollows)
{
    const V3f n = mapped({0.6f, 0, 0.8f}, flat_point, {}, -0.5f);
    EXPECT_NEAR(n.x / n.z, -0.3f, 1e-6f);
    const V3f fixed = mapped({0.6f, 0, 0.8f}, flat_point, {}, -0.5f, "WORLD");
    EXPECT_EQ(fixed, flat_point.ns) << "in other spaces it counts as 0";
}

TEST(NormalMapNode, strength_blends_from_flat)
{
    const auto slope = [](float strength) {
        const V3f n = mapped({0.6f, 0, 0.8f}, flat_point, {}, strength);
        return n.x / n.z;
    };
    EXPECT_NEAR(slope(0.0f), 0.0f, rounding);
    EXPECT_NEAR(slope(0.5f), 0.3f / 0.9f, rounding);
    EXPECT_NEAR(slope(2.0f), 1.2f / 0.8f, rounding);
    EXPECT_NEAR(slope(-1.0f), -0.6f, rounding);
}

TEST(NormalMapNode, the_back_of_a_bump_is_a_dent)
{
    // Seen from behind: the point is turned to the viewer, the mesh and its tangent are not.
    ShadingPoint point = flat_point;
    point.backfacing = true;
    MadeUpHit hit;
    hit.smooth = -up;
    hit.frame.bitangent_sign = -1.0f;  // so that the bitangent is that of the front
    EXPECT_LT((mapped({0.6f, 0, 0.8f}, point, hit) - V3f(-0.6f, 0, 0.8f)).length(), rounding);
}

TEST(NormalMapNode, without_a_tangent_the_normal_is_left_alone)
{
    MadeUpHit hit;
    hit.frame.tangent = V3f(0.0f);
    EXPECT_EQ(mapped({0.6f, 0, 0.8f}, flat_point, hit), up);
}

TEST(NormalMapNode, map_of_the_world_is_the_normal)
{
    const V3f n = direction_at(40.0, 70.0);
    EXPECT_LT((mapped(n, flat_point, {}, 1.0f, "WORLD") - n).length(), rounding);
    // Old bakes have y and z the other way.
    EXPECT_LT((mapped({n.x, -n.y, -n.z}, flat_point, {}, 1.0f, "BLENDER_WORLD") - n).length(),
              rounding);
    const V3f half = mapped(n, flat_point, {}, 0.5f, "WORLD");
    EXPECT_LT((half - (up + n).normalized()).length(), rounding);
}

TEST(NormalMapNode, map_of_the_object_turns_and_stretches_with_it)
{
    MadeUpHit hit;
    hit.facts.world_from_object.setScale(V3f(2, 1, 1));
    hit.facts.object_from_world = hit.facts.world_from_object.inverse();
    const V3f own = V3f(1, 0, 1).normalized();
    const V3f expected = V3f(1, 0, 2).normalized();
    EXPECT_LT((mapped(own, flat_point, hit, 1.0f, "OBJECT") - expected).length(), rounding);
    EXPECT_LT(
        (mapped({own.x, 0, -own.z}, flat_point, hit, 1.0f, "BLENDER_OBJECT") - expected).length(),
        rounding);
    ShadingPoint back = flat_point;
    back.backfacing = true;
    EXPECT_LT((mapped(-own, back, hit, 1.0f, "OBJECT") - expected).length(), rounding);
}

// A hit on the plane z = 0 whose attribute is a height over it. `height` must not outlive this.
class HeightField final : public MadeUpHit {
public:
    explicit HeightField(double (*height)(double, double), const V2f& at) : height_(height)
    {
        p_world = V3f(at.x, at.y, 0.0f);
    }

    [[nodiscard]] AttributeValue attribute(int) const override { return layer_at(p_world); }
    void moved(const V3f& offset,
               const std::function<void(const HitAttributes&)>& look) const override
    {
        look(HeightField(height_, {p_world.x + offset.x, p_world.y + offset.y}));
    }

    // Of the surface z = height(x, y), by central differences.
    [[nodiscard]] V3f normal(double scale) const
    {
        constexpr double step = 1e-4;
        const double x = double(p_world.x);
        const double y = double(p_world.y);
        const double dx = (height_(x + step, y) - height_(x - step, y)) / (2.0 * step);
        const double dy = (height_(x, y + step) - height_(x, y - step)) / (2.0 * step);
        return V3f(V3d(-scale * dx, -scale * dy, 1.0).normalized());
    }

private:
    [[nodiscard]] AttributeValue layer_at(const V3f& p) const
    {
        const auto h = static_cast<float>(height_(double(p.x), double(p.y)));
        return {.value = Color4f(h, h, h, 1.0f), .exists = true};
    }

    double (*height_)(double, double);
};

double waves(double x, double y) { return 0.3 * std::sin(2.0 * x) + 0.2 * std::cos(3.0 * y + x); }

// The normal of a mirror that the Bump node bends by the attribute.
V3f bumped(const HeightField& hit,
           const ShadingPoint& point,
           std::map<std::string, float> inputs,
           bool is_inverted = false)
{
    GraphTrial trial;
    const std::size_t height = trial.add("ATTRIBUTE", {{"attribute_name", "height"}});
    const std::size_t bump = trial.add("BUMP", {{"invert", is_inverted ? 1.0 : 0.0}});
    const std::size_t mirror = trial.add("BSDF_GLOSSY");
    trial.graph.set(mirror, "Roughness", V3f(0.0f));
    for (const auto& [input, value] : inputs) {
        trial.graph.set(bump, input, V3f(value));
    }
    trial.link(bump, "Height", height, "Fac");
    trial.link(mirror, "Normal", bump, "Normal");
    const ShaderProgram program = trial.surface(mirror, "BSDF");
    const PathState path;
    const auto s = program.shade({.point = point, .attributes = hit, .path = path})
                       .bsdf.sample(0.5f, {0.5f, 0.5f});
    return s ? (s->wi + point.wo).normalized() : V3f(0.0f);
}

// Of the steps that are differenced: 1e-3 long on waves of curvature 2.
constexpr float step_error = 2e-3f;

TEST(BumpNode, is_the_normal_of_the_surface_that_is_lifted)
{
    for (const V2f& at : {V2f(0.2f, 0.1f), V2f(-1.3f, 0.7f), V2f(2.0f, -0.4f)}) {
        for (double view_deg : {0.0, 10.0, 20.0}) {
            const HeightField hit(waves, at);
            const ShadingPoint point{
                .wo = direction_at(view_deg, 30.0), .ng = up, .ns = up, .footprint = 1e-3f};
            // So low that the mirror sees no surface.
            for (float distance : {0.25f, 0.5f, -0.35f}) {
                const V3f found = bumped(hit, point, {{"Distance", distance}});
                EXPECT_LT((found - hit.normal(double(distance))).length(), step_error)
                    << at << " seen at " << view_deg << " deg, distance " << distance;
                const V3f inverted = bumped(hit, point, {{"Distance", distance}}, true);
                EXPECT_LT((inverted - hit.normal(-double(distance))).length(), step_error);
            }
        }
    }
}

TEST(BumpNode, strength_is_how_far_the_normal_goes)
{
    const HeightField hit(waves, {0.2f, 0.1f});
    const ShadingPoint point{.wo = up, .ng = up, .ns = up, .footprint = 1e-3f};
    EXPECT_EQ(bumped(hit, point, {{"Strength", 0.0f}}), up);
    EXPECT_EQ(bumped(hit, point, {{"Strength", -1.0f}}), up);
    const V3f half = bumped(hit, point, {{"Strength", 0.5f}});
    EXPECT_LT((half - (up + hit.normal(1.0)).normalized()).length(), step_error);
}

TEST(BumpNode, what_is_finer_than_a_pixel_bends_nothing)
{
    constexpr auto fine = [](double x, double y) { return 1e-3 * (std::sin(1e4 * x) + 0.0 * y); };
    const HeightField hit(fine, {0.0f, 0.0f});
    const ShadingPoint point{.wo = up, .ng = up, .ns = up, .footprint = 1.0f};
    EXPECT_LT((bumped(hit, point, {}) - up).length(), 5e-3f);
    ShadingPoint near = point;
    near.footprint = 1e-6f;
    EXPECT_GT((bumped(hit, near, {}) - up).length(), 0.5f);
}

TEST(BumpNode, bends_a_normal_that_another_node_bent)
{
    const MadeUpHit hit;
    const V3f tilted = direction_at(20.0);
    const AskedNode node{.type = "BUMP", .inputs = {{"Normal", tilted}, {"Height", V3f(0.3f)}}};
    EXPECT_LT((node("Normal", hit, flat_point) - tilted).length(), rounding)
        << "an even height bends nothing";
}

TEST(BumpNode, filter_width_is_the_step_in_pixels)
{
    // A parabola's slope, taken over a step d from its middle, is d.
    constexpr auto parabola = [](double x, double y) { return x * x + y * y; };
    const HeightField hit(parabola, {0.0f, 0.0f});
    const ShadingPoint point{.wo = up, .ng = up, .ns = up, .footprint = 0.1f};
    for (const float width_px : {0.1f, 1.0f, 2.0f}) {
        const V3f found = bumped(hit, point, {{"Filter Width", width_px}});
        // Along two axes, so the root of 2 as steep.
        EXPECT_NEAR(std::hypot(found.x, found.y) / found.z, std::sqrt(2.0f) * 0.1f * width_px,
                    1e-4f)
            << width_px;
    }
}

TEST(Bump, steps_lie_across_each_other_in_the_surface_as_far_as_a_pixel_seen_from_above)
{
    for (const V3f& ng : {up, direction_at(40.0, 70.0), V3f(1.0f).normalized()}) {
        const ShadingPoint point{.wo = ng, .ng = ng, .ns = ng, .footprint = 0.1f};
        const auto steps = bump_offsets(point, V3f(0.0f));
        for (const V3f& step : steps) {
            EXPECT_NEAR(step.dot(ng), 0.0f, 1e-7f);
            EXPECT_NEAR(step.length(), 0.1f, 1e-6f);
        }
        EXPECT_NEAR(steps[0].dot(steps[1]), 0.0f, 1e-7f);
    }
    const ShadingPoint unknown{.wo = up, .ng = up, .ns = up};
    for (const V3f& step : bump_offsets(unknown, V3f(1e4f, 0, 0))) {
        EXPECT_GT(step.length(), 10.0f * 1e-3f) << "longer than floats are apart there";
    }
}

TEST(DisplacementNode, lifts_along_the_normal_by_the_objects_or_the_worlds_measure)
{
    MadeUpHit hit;
    hit.facts.world_from_object.setScale(V3f(2, 2, 3));
    const auto lifted = [&](const char* space) {
        return AskedNode{.type = "DISPLACEMENT",
                         .options = {{"space", space}},
                         .inputs = {{"Height", V3f(0.75f)},
                                    {"Midlevel", V3f(0.25f)},
                                    {"Scale", V3f(4.0f)}}}("Displacement", hit, flat_point);
    };
    EXPECT_LT((lifted("WORLD") - V3f(0, 0, 2)).length(), rounding);
    EXPECT_LT((lifted("OBJECT") - V3f(0, 0, 6)).length(), rounding);
}

TEST(VectorDisplacementNode, moves_in_the_space_that_is_named)
{
    MadeUpHit hit;
    hit.facts.world_from_object.setScale(V3f(2, 2, 3));
    hit.facts.object_from_world = hit.facts.world_from_object.inverse();
    const auto moved = [&](const char* space) {
        return AskedNode{.type = "VECTOR_DISPLACEMENT",
                         .options = {{"space", space}},
                         .inputs = {{"Vector", V3f(1.25f, 2.25f, 3.25f)},
                                    {"Midlevel", V3f(0.25f)},
                                    {"Scale", V3f(0.5f)}}}("Displacement", hit, flat_point);
    };
    EXPECT_LT((moved("WORLD") - V3f(0.5f, 1.0f, 1.5f)).length(), rounding);
    EXPECT_LT((moved("OBJECT") - V3f(1.0f, 2.0f, 4.5f)).length(), rounding);
    // Along the tangent, the normal, and across both: red, green and blue.
    EXPECT_LT((moved("TANGENT") - V3f(1.0f, 3.0f, 3.0f)).length(), rounding);
}

}  // namespace
}  // namespace eye_render
