// The choice among lights: what `choose` does is what `probability` says, for every kind of scene.

#include "scene/light_sampler.h"

#include "../base/chi_squared.h"
#include "scene/environment.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>
#include <string>

namespace eye_render {
namespace {

LitPoint weighed(const LightSampler& sampler, const V3f& p, const V3f& n)
{
    LitPoint point;
    sampler.weigh(p, n, point);
    return point;
}

Lamp lamp_at(LampSettings settings, const V3f& position)
{
    settings.world_from_light.setTranslation(position);
    return make_lamp(settings);
}

const LampSettings point{.color = Color3f(100.0f)};
const LampSettings area{.kind = LampKind::Area, .color = Color3f(100.0f)};
const LampSettings spot{.kind = LampKind::Spot, .color = Color3f(100.0f), .spot_angle_rad = 0.6f};
const LampSettings sun{.kind = LampKind::Sun, .color = Color3f(3.0f), .angle_rad = 0.01f};

struct Lights {
    std::string name;
    std::vector<Lamp> lamps{};
    std::vector<EmissiveTriangle> triangles{};
    Environment environment{};

    LightSampler sampler() const { return {lamps, triangles, environment}; }

    double sum_of_probabilities(const LightSampler& sampler, const V3f& p, const V3f& n) const
    {
        double sum =
            double(sampler.probability(LightKind::Environment, 0, weighed(sampler, p, n)));
        for (std::uint32_t i = 0; i < lamps.size(); ++i) {
            sum += double(sampler.probability(LightKind::Lamp, i, weighed(sampler, p, n)));
        }
        for (std::uint32_t i = 0; i < triangles.size(); ++i) {
            sum += double(sampler.probability(LightKind::Triangle, i, weighed(sampler, p, n)));
        }
        return sum;
    }
};

std::vector<EmissiveTriangle> random_triangles(int count)
{
    std::mt19937 rng(3);
    std::uniform_real_distribution<float> uniform(-10.0f, 10.0f);
    std::vector<EmissiveTriangle> triangles;
    for (int i = 0; i < count; ++i) {
        const V3f p(uniform(rng), uniform(rng), uniform(rng));
        const V3f a = V3f(uniform(rng), uniform(rng), uniform(rng)) * 0.05f;
        const V3f b = V3f(uniform(rng), uniform(rng), uniform(rng)) * 0.05f;
        triangles.push_back({p, p + a, p + b, float(i % 7)});  // every seventh is black
    }
    return triangles;
}

std::vector<Lights> scenes()
{
    static const Material even = plain_material("BACKGROUND", {{"Color", V3f(1.0f)}});
    static const SceneFrame frame;
    const Environment sky(even, frame);
    Lights few{.name = "a few of each",
               .lamps = {lamp_at(point, {0, 0, 3}), lamp_at(area, {1, 2, 4}),
                         lamp_at(spot, {-2, 0, 5}), lamp_at(sun, {0, 0, 0}),
                         lamp_at({.color = Color3f(0.0f)}, {1, 1, 1})},
               .triangles = random_triangles(20),
               .environment = sky};
    Lights many{.name = "more lamps than clusters", .triangles = random_triangles(3000)};
    for (int i = 0; i < 500; ++i) {
        const V3f position(float(i % 10), float(i / 10 % 10), float(i / 100) + 1.0f);
        many.lamps.push_back(lamp_at(i % 3 == 0 ? area : i % 3 == 1 ? point : spot, position));
    }
    for (int i = 0; i < 20; ++i) {
        many.lamps.push_back(lamp_at(sun, V3f(float(i))));
    }
    Lights together{.name = "many lamps at one place"};
    together.lamps.assign(100, lamp_at(point, {1, 2, 3}));
    return {few,
            many,
            together,
            {.name = "one lamp", .lamps = {lamp_at(point, {0, 0, 3})}},
            {.name = "the sky alone", .environment = sky}};
}

struct Place {
    V3f p, n;
};

const Place places[] = {
    {{0, 0, 0}, {0, 0, 1}},         {{0, 0, 0}, {0, 0, -1}},
    {{0, 0, 0}, {0, 0, 0}},          // light from all sides
    {{0, 0, 3}, {0.6f, 0, 0.8f}},    // at a lamp
    {{1e4f, -2e4f, 50}, {1, 0, 0}},  // far away
};

TEST(LightSampler, probabilities_sum_to_one)
{
    for (const Lights& lights : scenes()) {
        const LightSampler sampler = lights.sampler();
        for (const auto& [p, n] : places) {
            EXPECT_NEAR(lights.sum_of_probabilities(sampler, p, n), 1.0, 1e-4)
                << lights.name << " at " << p << " normal " << n;
        }
    }
}

TEST(LightSampler, chooses_as_often_as_the_probability_says)
{
    constexpr int count = 200000;
    const double tests = double(scenes().size() * std::size(places));
    const double significance = 1.0 - std::pow(1.0 - 0.01, 1.0 / tests);  // Sidak
    std::mt19937 rng(7);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (const Lights& lights : scenes()) {
        const LightSampler sampler = lights.sampler();
        for (const auto& [p, n] : places) {
            std::map<std::pair<LightKind, std::uint32_t>, int> chosen;
            for (int i = 0; i < count; ++i) {
                const auto choice = sampler.choose(weighed(sampler, p, n), uniform(rng));
                ASSERT_TRUE(choice);
                ++chosen[{choice->kind, choice->index}];
            }
            std::vector<double> observed;
            std::vector<double> expected;
            const auto add = [&](LightKind kind, std::size_t lights_of_kind) {
                for (std::uint32_t i = 0; i < lights_of_kind; ++i) {
                    const double probability =
                        double(sampler.probability(kind, i, weighed(sampler, p, n)));
                    if (probability > 0.0) {
                        expected.push_back(count * probability);
                        observed.push_back(chosen[{kind, i}]);
                    }
                }
            };
            add(LightKind::Environment, 1);
            add(LightKind::Lamp, lights.lamps.size());
            add(LightKind::Triangle, lights.triangles.size());
            if (observed.size() == 1) {
                EXPECT_EQ(observed[0], count) << lights.name;
                continue;
            }
            const test::ChiSquared chi = test::chi_squared_test(observed, expected, significance);
            EXPECT_LT(chi.statistic, chi.critical) << lights.name << " at " << p;
        }
    }
}

// What is left of a number after the choice of a cluster must still tell its members apart.
TEST(LightSampler, each_of_400_000_faint_lights_beside_a_bright_one_gets_its_share)
{
    const std::vector<Lamp> bright = {lamp_at({.color = Color3f(1e9f)}, {0, 0, 1})};
    const std::vector<EmissiveTriangle> faint = random_triangles(400000);
    const LightSampler sampler(bright, faint, Environment());
    const LitPoint lit = weighed(sampler, {0, 0, 0}, {0, 0, 1});
    // The lamp is the first cluster: the triangles share what is above its probability.
    const double start = double(sampler.probability(LightKind::Lamp, 0, lit));
    constexpr int count = 4000000;
    std::vector<int> chosen(faint.size(), 0);
    for (int i = 0; i < count; ++i) {
        const auto choice = sampler.choose(lit, start + (1.0 - start) * (i + 0.5) / count);
        ASSERT_TRUE(choice && choice->kind == LightKind::Triangle);
        ++chosen[choice->index];
    }
    for (std::uint32_t i = 0; i < faint.size(); ++i) {
        const double expected =
            count / (1.0 - start) * double(sampler.probability(LightKind::Triangle, i, lit));
        // Each end of its share misplaces one number at most; some shares come in several pieces.
        ASSERT_NEAR(chosen[i], expected, 4.0 + 0.05 * expected) << i;
    }
}

TEST(LightSampler, a_choice_carries_its_own_probability)
{
    for (const Lights& lights : scenes()) {
        const LightSampler sampler = lights.sampler();
        for (const auto& [p, n] : places) {
            for (int i = 0; i <= 1000; ++i) {
                const auto c = sampler.choose(weighed(sampler, p, n),
                                              std::min(float(i) * 1e-3f, 0x1.fffffep-1f));
                ASSERT_TRUE(c);
                EXPECT_EQ(c->probability,
                          sampler.probability(c->kind, c->index, weighed(sampler, p, n)))
                    << lights.name << " at " << p;
            }
        }
    }
}

TEST(LightSampler, every_light_that_reaches_the_point_can_be_chosen)
{
    for (const Lights& lights : scenes()) {
        const LightSampler sampler = lights.sampler();
        for (const auto& [p, n] : places) {
            for (std::uint32_t i = 0; i < lights.lamps.size(); ++i) {
                if (sample_lamp(lights.lamps[i], p, {0.5f, 0.5f})) {
                    EXPECT_GT(sampler.probability(LightKind::Lamp, i, weighed(sampler, p, n)),
                              0.0f)
                        << lights.name << " at " << p << ", lamp " << i;
                }
            }
        }
    }
}

TEST(LightSampler, black_lights_are_never_chosen)
{
    const Lights lights = scenes()[0];
    const LightSampler sampler = lights.sampler();
    for (const auto& [p, n] : places) {
        EXPECT_EQ(sampler.probability(LightKind::Lamp, 4, weighed(sampler, p, n)), 0.0f);
        EXPECT_EQ(sampler.probability(LightKind::Triangle, 0, weighed(sampler, p, n)), 0.0f);
    }
    const LightSampler nothing(std::span(&lights.lamps[4], 1), {}, Environment());
    EXPECT_FALSE(nothing.choose(weighed(nothing, {0, 0, 0}, {0, 0, 1}), 0.5f));
    EXPECT_EQ(nothing.probability(LightKind::Lamp, 0, weighed(nothing, {0, 0, 0}, {0, 0, 1})),
              0.0f);
    EXPECT_FALSE(LightSampler().choose(LitPoint(), 0.5f));
    EXPECT_EQ(LightSampler().probability(LightKind::Environment, 0, LitPoint()), 0.0f);
}

TEST(LightSampler, prefers_the_lamp_that_gives_more)
{
    const std::vector<Lamp> lamps = {lamp_at(point, {0, 0, 1}), lamp_at(point, {0, 0, 10}),
                                     lamp_at(point, {0, 0, -1})};
    const LightSampler sampler(lamps, {}, Environment());
    const auto probability = [&](std::uint32_t i) {
        return sampler.probability(LightKind::Lamp, i, weighed(sampler, {0, 0, 0}, {0, 0, 1}));
    };
    EXPECT_GT(probability(0), 0.9f);
    EXPECT_GT(probability(1), probability(2));  // the third is behind the surface
    // An area lamp's back and the outside of a spot's cone count for next to nothing.
    const std::vector<Lamp> turned = {lamp_at(point, {0, 0, 5}), lamp_at(area, {0, 0, -5}),
                                      lamp_at(spot, {20, 0, 5})};
    const LightSampler all_sides(turned, {}, Environment());
    EXPECT_GT(all_sides.probability(LightKind::Lamp, 0, weighed(all_sides, {0, 0, 0}, {0, 0, 0})),
              0.95f);
}

TEST(LightSampler, a_bright_triangle_among_many_is_found)
{
    std::vector<EmissiveTriangle> triangles = random_triangles(1000);
    triangles[500].radiance = 1e6f;
    const LightSampler sampler({}, triangles, Environment());
    EXPECT_GT(
        sampler.probability(LightKind::Triangle, 500, weighed(sampler, {0, 0, 0}, {0, 0, 0})),
        0.9f);
}

TEST(LightSampler, broken_points_still_get_a_light)
{
    const Lights lights = scenes()[0];
    const LightSampler sampler = lights.sampler();
    const V3f broken(NAN, 0.0f, INFINITY);
    const auto choice = sampler.choose(weighed(sampler, broken, {0, 0, 1}), 0.7f);
    ASSERT_TRUE(choice);
    EXPECT_GT(choice->probability, 0.0f);
}

TEST(LightSampler, triangle_area_is_half_the_cross_product)
{
    EXPECT_FLOAT_EQ(triangle_area({0, 0, 0}, {3, 0, 0}, {0, 4, 0}), 6.0f);
}

}  // namespace
}  // namespace eye_render
