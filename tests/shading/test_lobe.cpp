// Every kind of lobe: what is sampled against what is evaluated, and both against physics.

#include "../base/chi_squared.h"
#include "lobe_cases.h"
#include "shading/ggx_surface.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::Case;
using test::direction_at;
using test::lobe_cases;
using test::mixture;
using test::Random;
using test::up;

constexpr double view_angles_deg[] = {5.0, 50.0, 80.0};

TEST(Lobe, samples_follow_the_density_of_evaluate)
{
    constexpr int heights = 20;
    constexpr int azimuths = 20;
    constexpr int sub = 12;  // quadrature points a cell and axis
    constexpr int samples = 100000;
    constexpr double edge_error = 4e-3;  // of the quadrature, where a density ends in a step
    const auto cell_of = [](const V3f& w) { return test::cell_of(w, heights, azimuths); };
    const double tests = double(lobe_cases().size() * std::size(view_angles_deg));
    const double significance = 1.0 - std::pow(1.0 - 0.01, 1.0 / tests);

    for (const Case& c : lobe_cases()) {
        for (double angle_deg : view_angles_deg) {
            const Bsdf bsdf = mixture(c, direction_at(angle_deg));
            // One cell more: light that is absorbed, or passes as a delta.
            constexpr std::size_t rest = heights * azimuths;
            std::vector<double> expected(rest + 1), observed(rest + 1);
            double density = 0.0;
            test::for_each_direction(
                heights * sub, azimuths * sub, [&](const V3f& wi, double solid_angle) {
                    const double share = double(bsdf.evaluate(wi).pdf) * solid_angle;
                    expected[cell_of(wi)] += samples * share;
                    density += share;
                });
            EXPECT_LT(density, 1.0 + edge_error) << c.name << ", " << angle_deg << " deg";
            expected[rest] = samples * std::max(0.0, 1.0 - density);
            Random random(7);
            for (int i = 0; i < samples; ++i) {
                const std::optional<BsdfSample> s = random.sample(bsdf);
                ++observed[s && !s->is_delta ? cell_of(s->wi) : rest];
            }
            const test::ChiSquared fit = test::chi_squared_test(observed, expected, significance);
            EXPECT_LT(fit.statistic, fit.critical) << c.name << ", " << angle_deg << " deg";
        }
    }
}

TEST(Lobe, a_glossy_toon_fills_its_cone_evenly)
{
    // Half angle 45 degrees, of which the outer 18 fade out; seen so that all of it is above the
    // surface.
    constexpr int bins = 20;
    constexpr int samples = 100000;
    const Lobe lobe = toon_lobe(LobeKind::GlossyToon, Color3f(1.0f), 0.3f, 0.2f, up, up);
    Bsdf bsdf(direction_at(40.0), up);
    bsdf.add(lobe, lobe.weight);
    const Frame around(direction_at(40.0, 180.0));
    const double rim = 1.0 - std::cos(pi / 4.0);
    std::vector<double> observed(bins * bins);
    Random random(5);
    for (int i = 0; i < samples; ++i) {
        const std::optional<BsdfSample> s = random.sample(bsdf);
        ASSERT_TRUE(s);
        ASSERT_NEAR(s->pdf * 2.0 * pi * rim, 1.0, 1e-5);
        const V3f w = around.local_from_world(s->wi);
        const double height = (1.0 - double(w.z)) / rim;
        const double turn = 0.5 + std::atan2(double(w.y), double(w.x)) / (2.0 * pi);
        ++observed[std::size_t(std::min(int(height * bins), bins - 1) * bins +
                               std::min(int(turn * bins), bins - 1))];
        const double angle = std::acos(double(w.z)) / pi * 180.0;
        ASSERT_NEAR(s->weight.x, std::min(1.0, (45.0 - angle) / 18.0), 1e-3);
    }
    const std::vector<double> expected(bins * bins, double(samples) / (bins * bins));
    const test::ChiSquared fit = test::chi_squared_test(observed, expected, 0.01);
    EXPECT_LT(fit.statistic, fit.critical);
}

TEST(Lobe, ashikhmin_and_shirleys_without_roughness_is_a_mirror)
{
    Bsdf bsdf(direction_at(40.0), up);
    add_phong(bsdf, {.normal = up, .cos_o = direction_at(40.0).z, .roughness = 0.0f},
              Color3f(0.8f));
    Random random(4);
    for (int i = 0; i < 100; ++i) {
        const std::optional<BsdfSample> s = random.sample(bsdf);
        ASSERT_TRUE(s && s->is_delta);
        EXPECT_LT((s->wi - direction_at(40.0, 180.0)).length(), 1e-3f);
        EXPECT_FLOAT_EQ(s->weight.x, 0.8f);
    }
}

TEST(Lobe, the_weight_of_a_sample_is_its_value_over_its_density)
{
    for (const Case& c : lobe_cases()) {
        for (double angle_deg : view_angles_deg) {
            const Bsdf bsdf = mixture(c, direction_at(angle_deg));
            Random random(3);
            for (int i = 0; i < 1000; ++i) {
                const std::optional<BsdfSample> s = random.sample(bsdf);
                if (!s || s->is_delta) {
                    continue;
                }
                const BsdfValue f = bsdf.evaluate(s->wi);
                ASSERT_NEAR(s->pdf, f.pdf, 1e-5f * f.pdf) << c.name;
                const Color3f error = s->weight - f.value / f.pdf;
                ASSERT_LE(error.length(), 1e-5f * s->weight.length()) << c.name;
            }
        }
    }
}

TEST(Lobe, samples_average_to_the_integral_of_evaluate)
{
    constexpr int samples = 100000;
    for (const Case& c : lobe_cases()) {
        const Bsdf bsdf = mixture(c, direction_at(50.0));
        const double expected = test::integrate(bsdf).value.y;
        Random random(11);
        double sum = 0.0;
        double squares = 0.0;
        for (int i = 0; i < samples; ++i) {
            const std::optional<BsdfSample> s = random.sample(bsdf);
            const double weight = s && !s->is_delta ? double(s->weight.y) : 0.0;
            sum += weight;
            squares += weight * weight;
        }
        const double mean = sum / samples;
        const double deviation =
            std::sqrt(std::max(0.0, squares / samples - mean * mean) / samples);
        // Four deviations, and what the grid of the integral misses.
        EXPECT_NEAR(mean, expected, 4.0 * deviation + 1e-3) << c.name;
    }
}

TEST(Lobe, a_narrow_lobe_samples_with_bounded_weights)
{
    // Visible normals leave only G2 / G1 in the weight of a lone lobe.
    for (float alpha : {smallest_rough_alpha, 2e-3f, 0.05f}) {
        for (double angle_deg : {0.0, 50.0, 89.0}) {
            Bsdf bsdf(direction_at(angle_deg), up);
            bsdf.add(glossy_lobe(Color3f(1.0f), up, alpha), Color3f(1.0f));
            Random random(5);
            for (int i = 0; i < 1000; ++i) {
                if (const std::optional<BsdfSample> s = random.sample(bsdf)) {
                    ASSERT_LE(s->weight.x, 1.0f + 1e-5f) << alpha << " " << angle_deg;
                    ASSERT_NEAR(s->wi.length(), 1.0f, 1e-5f);
                }
            }
        }
    }
}

TEST(Lobe, reflection_is_reciprocal)
{
    // f(a, b) = f(b, a), and evaluate includes the cosine of the light's direction.
    const V3f a = direction_at(20.0, 15.0);
    const V3f b = direction_at(70.0, 150.0);
    for (const Case& c : lobe_cases()) {
        // What was made for one viewer has no other, toon's cones are not of this world, and
        // velvet is only as its authors wrote it down.
        const LobeKind kind = c.lobes[0].kind;
        if (c.lobes[0].normal != up || !c.lobes[0].reflects() || kind == LobeKind::Sheen ||
            kind == LobeKind::OrenNayar || kind == LobeKind::DiffuseToon ||
            kind == LobeKind::GlossyToon || kind == LobeKind::Velvet ||
            kind == LobeKind::Fibre) {  // whose scales are tilted
            continue;
        }
        const Color3f ab = mixture(c, a).evaluate(b).value / b.z;
        const Color3f ba = mixture(c, b).evaluate(a).value / a.z;
        EXPECT_GT(ab.x, 0.0f) << c.name;
        EXPECT_LT((ab - ba).length(), 1e-5f * ab.length()) << c.name;
    }
}

TEST(Lobe, transmission_is_reciprocal_as_basic_radiance)
{
    // Seen from the other side: f(a, b) / n_b^2 = f(b, a) / n_a^2 (Veach 1997, eq. 5.14), and
    // there is no such factor when what is carried is radiance over n^2; but evaluate's densities
    // are still per solid angle of wi, which refraction squeezes by n^2 cos / cos.
    const float ior = 1.45f;
    const V3f a = direction_at(30.0);
    const V3f b = -direction_at(20.0, 10.0);
    Bsdf from_a(a, up);
    from_a.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, 0.5f, ior), Color3f(1.0f));
    Bsdf from_b(b, -up);
    from_b.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), -up, 0.5f, 1.0f / ior), Color3f(1.0f));
    const float ab = from_a.evaluate(b).value.x / -b.z;
    const float ba = from_b.evaluate(a).value.x / a.z;
    EXPECT_GT(ab, 0.0f);
    EXPECT_NEAR(ab / (ior * ior), ba, 1e-4f * ba);
}

}  // namespace
}  // namespace eye_render
