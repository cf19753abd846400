// Ambient Occlusion and Bevel, in surroundings that a test makes up.

#include "asked_node.h"
#include "base/units.h"
#include "shading/bevel_kernel.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

using test::AskedNode;
using test::MadeUpHit;

const V3f up(0.0f, 0.0f, 1.0f);

// A ridge of two planes that meet at a right angle along y: the hit lies on the upper one,
// `to_edge` from the edge, and the other one falls away there.
class Ridge final : public SurfaceProbe {
public:
    float to_edge = 1.0f;
    std::uint64_t number = 1;
    mutable float longest_look = 0.0f;
    mutable bool was_local = false;

    // The sky is blocked on the side of +x.
    [[nodiscard]] bool is_blocked(const V3f& d, float distance, bool local) const override
    {
        longest_look = distance;
        was_local = local;
        return d.x > 0.0f;
    }
    void cross_own_object(const V3f& start,
                          const V3f& direction,
                          float length,
                          const std::function<void(const Crossing&)>& visit) const override
    {
        const auto meet = [&](const V3f& n, const V3f& on_plane, auto is_inside) {
            const float along = direction.dot(n);
            const float t = (on_plane - start).dot(n) / along;
            const V3f p = start + direction * t;
            if (along != 0.0f && t >= 0.0f && t <= length && is_inside(p)) {
                visit({.from_hit = p, .ng = n, .ns = n});
            }
        };
        meet(up, V3f(0.0f), [&](const V3f& p) { return p.x <= to_edge; });
        meet(V3f(1, 0, 0), V3f(to_edge, 0, 0), [&](const V3f& p) { return p.z <= 0.0f; });
    }
    [[nodiscard]] std::uint64_t seed() const override { return number; }
};

const ShadingPoint seen_from_above{.wo = up, .ng = up, .ns = up};

NodeValue ask(const AskedNode& node,
              const char* output,
              const SurfaceProbe* probe,
              const PathState& path = {},
              const ShadingPoint& point = seen_from_above)
{
    const MadeUpHit hit;
    return node(output, {.point = point, .attributes = hit, .path = path, .probe = probe});
}

TEST(AmbientOcclusionNode, is_the_share_of_the_hemisphere_that_is_open)
{
    const Ridge half;
    const AskedNode node{.type = "AMBIENT_OCCLUSION",
                         .options = {{"samples", 1024.0}},
                         .inputs = {{"Distance", V3f(3.0f)}, {"Color", V3f(0.2f, 0.4f, 0.8f)}}};
    // 1024 stratified samples of a half: the edge passes 32 of the strata.
    EXPECT_NEAR(ask(node, "AO", &half).x, 0.5f, 0.02f);
    EXPECT_EQ(half.longest_look, 3.0f);
    EXPECT_FALSE(half.was_local);
    EXPECT_NEAR(ask(node, "Color", &half).z, 0.4f, 0.02f);
}

TEST(AmbientOcclusionNode, looks_inside_and_at_its_own_object_on_request)
{
    const Ridge half;
    AskedNode node{.type = "AMBIENT_OCCLUSION",
                   .options = {{"samples", 64.0}, {"inside", 1.0}, {"only_local", 1.0}},
                   .inputs = {{"Normal", V3f(-0.6f, 0.0f, 0.8f)}}};
    const float inside = ask(node, "AO", &half).x;
    EXPECT_TRUE(half.was_local);
    node.options["inside"] = 0.0;
    // Cosine-weighted, a plane through the axis and tilted by asin(0.6) leaves (1 +- 0.6) / 2.
    EXPECT_NEAR(ask(node, "AO", &half).x, 0.8f, 0.05f);
    EXPECT_NEAR(inside, 0.2f, 0.05f);
}

TEST(AmbientOcclusionNode, is_open_where_no_rays_may_be_sent)
{
    EXPECT_EQ(ask({.type = "AMBIENT_OCCLUSION"}, "AO", nullptr).x, 1.0f);
    const Ridge half;
    const AskedNode near{.type = "AMBIENT_OCCLUSION", .inputs = {{"Distance", V3f(0.0f)}}};
    EXPECT_EQ(ask(near, "AO", &half).x, 1.0f);
}

// Mean over many hits of what a bevel makes of an edge.
V3f mean_bevel(float to_edge, bool backfacing = false)
{
    const AskedNode node{
        .type = "BEVEL", .options = {{"samples", 16.0}}, .inputs = {{"Radius", V3f(1.0f)}}};
    ShadingPoint point = seen_from_above;
    point.backfacing = backfacing;
    V3f sum(0.0f);
    constexpr int hits = 400;
    for (std::uint64_t i = 0; i < hits; ++i) {
        Ridge ridge;
        ridge.to_edge = to_edge;
        ridge.number = i;
        sum += ask(node, "Normal", &ridge, {}, point) / hits;
    }
    return sum;
}

TEST(BevelNode, turns_the_normal_half_way_at_an_edge_and_not_at_all_a_radius_away)
{
    const V3f at_edge = mean_bevel(0.0f);
    // On the edge, both planes are equally near; 400 hits of 16 rays scatter by about 0.02.
    EXPECT_NEAR(at_edge.x, at_edge.z, 0.06f);
    EXPECT_GT(at_edge.x, 0.6f);
    EXPECT_LT((mean_bevel(1.0f) - up).length(), 1e-5f);
    const V3f between = mean_bevel(0.5f);
    EXPECT_GT(between.x, 0.02f);
    EXPECT_LT(between.x, 0.5f * at_edge.x);
    EXPECT_NEAR(between.y, 0.0f, 1e-5f);
}

TEST(BevelNode, turns_away_where_the_back_is_seen) { EXPECT_LT(mean_bevel(0.0f, true).x, -0.6f); }

TEST(BevelNode, leaves_the_normal_to_blurred_light_and_where_no_rays_may_be_sent)
{
    Ridge ridge;
    ridge.to_edge = 0.0f;
    const AskedNode node{.type = "BEVEL", .inputs = {{"Radius", V3f(1.0f)}}};
    EXPECT_EQ(ask(node, "Normal", nullptr), up);
    EXPECT_EQ(ask(node, "Normal", &ridge, {.smallest_pdf = 1.0f}), up);
    EXPECT_NE(ask(node, "Normal", &ridge, {.smallest_pdf = 100.0f}), up);
}

TEST(BevelNode, bends_a_normal_that_is_bent_already)
{
    const Ridge far{};
    const V3f bent = V3f(0.0f, 0.6f, 0.8f);
    const AskedNode node{.type = "BEVEL", .inputs = {{"Radius", V3f(0.5f)}, {"Normal", bent}}};
    EXPECT_NEAR((ask(node, "Normal", &far) - bent).length(), 0.0f, 1e-6f);
}

TEST(BevelKernel, falls_off_to_one_over_the_disk_and_is_sampled_so)
{
    constexpr int steps = 1000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) {
        const double r = 2.0 * (i + 0.5) / steps;
        sum += double(bevel_falloff(float(r), 2.0f)) * 2.0 * pi * r * (2.0 / steps);
    }
    EXPECT_NEAR(sum, 1.0, 1e-4);
    for (const float u : {0.0f, 1e-4f, 0.1f, 0.5f, 0.9f, 0.999f, 0.99999994f}) {
        const double r = double(sample_bevel_distance(u));
        EXPECT_NEAR(10 * r * r - 20 * r * r * r + 15 * std::pow(r, 4) - 4 * std::pow(r, 5),
                    double(u), 2e-6)
            << u;
        EXPECT_LE(r, 1.0);
    }
}

}  // namespace
}  // namespace eye_render
