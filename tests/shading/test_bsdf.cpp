// Mixtures and single lobes: what is sampled against what is evaluated, and both against physics.

#include "../base/chi_squared.h"
#include "scattering.h"
#include "shading/diffuse_lobe.h"
#include "shading/frame.h"
#include "shading/glossy_lobe.h"
#include "shading/microfacet.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

const V3f tilted = direction_at(25.0, 70.0);

struct Case {
    std::string name;
    std::vector<Lobe> lobes;
};

[[nodiscard]] Lobe brushed(Lobe lobe)
{
    lobe.alpha_x *= 0.6f;
    lobe.alpha_y /= 0.6f;
    lobe.tangent = Frame(lobe.normal).world_from_local(V3f(0.8f, 0.6f, 0.0f));
    return lobe;
}

[[nodiscard]] Lobe beckmann(Lobe lobe)
{
    lobe.facets = FacetModel::Beckmann;
    return lobe;
}

// A sheen's transform as the table has it at a roughness of one half, seen at 45 degrees.
[[nodiscard]] Lobe sheen(const Color3f& weight, const V3f& normal)
{
    Lobe lobe = plain_lobe(LobeKind::Sheen, weight, normal);
    lobe.smooth_normal = up;
    lobe.a = 0.44f;
    lobe.b = -0.06f;
    return lobe;
}

// What depends on the viewer is made for one at 50 degrees, which any viewer may see.
[[nodiscard]] std::vector<Case> wide_cases()
{
    const Color3f orange(0.9f, 0.5f, 0.2f);
    const auto oren_nayar = [&](const V3f& normal) {
        return oren_nayar_lobe(orange, orange, 0.7f, normal, up, direction_at(50.0)).lobe;
    };
    return {
        {"Oren-Nayar", {oren_nayar(up)}},
        {"Oren-Nayar, mapped normal", {oren_nayar(tilted)}},
        {"translucent", {translucent_lobe(orange, up, up)}},
        {"translucent, mapped normal", {translucent_lobe(orange, tilted, up)}},
        {"sheen", {sheen(orange, up)}},
        {"sheen, mapped normal", {sheen(orange, tilted)}},
        {"diffuse toon", {toon_lobe(LobeKind::DiffuseToon, orange, 0.6f, 0.3f, up, up)}},
        {"velvet", {velvet_lobe(orange, up, 0.7f)}},
    };
}

// Rough enough for a grid of directions to resolve.
std::vector<Case> lobe_cases()
{
    const Color3f orange(0.9f, 0.5f, 0.2f);
    const Lobe diffuse = diffuse_lobe(orange, up, up);
    const Lobe glossy = glossy_lobe(orange, up, 0.25f);
    const Lobe metal = metal_lobe(Color3f(1.1f), up, 0.5f, orange);
    const Lobe dielectric = dielectric_lobe(Color3f(1.0f), up, 0.2f, 1.5f);
    const Lobe glass_in = glass_lobe(Color3f(1.0f), orange, up, 0.3f, 1.45f);
    const Lobe glass_out = glass_lobe(orange, orange, up, 0.3f, 1.0f / 1.45f);
    const Lobe straight = straight_lobe(Color3f(0.3f));
    Lobe tinted = glass_in;
    tinted.kind = LobeKind::TintedGlass;
    tinted.f0 = orange * 0.05f;
    Lobe film = tinted;
    film.film_thickness_nm = 400.0f;
    film.film_ior = 1.3f;
    Lobe conductor = plain_lobe(LobeKind::Conductor, Color3f(1.0f), up, 0.3f);
    conductor.f0 = Color3f(0.2f, 0.9f, 1.4f);
    conductor.edge = Color3f(3.9f, 2.4f, 2.0f);
    const Lobe phong = plain_lobe(LobeKind::AshikhminShirley, orange, up, 0.4f);
    std::vector<Case> cases = wide_cases();
    const std::vector<Case> facets{
        {"tinted glass", {tinted}},
        {"glass under a film", {film}},
        {"conductor", {conductor}},
        {"brushed metal", {brushed(metal)}},
        {"brushed metal, mapped normal", {brushed(metal_lobe(orange, tilted, 0.4f, orange))}},
        {"Beckmann's facets", {beckmann(glossy)}},
        {"Beckmann's facets, brushed", {beckmann(brushed(metal))}},
        {"Beckmann's glass", {beckmann(glass_in)}},
        {"refraction", {refraction_lobe(orange, up, 0.45f, 1.45f)}},
        {"refraction from inside", {refraction_lobe(orange, up, 0.3f, 1.0f / 1.45f)}},
        {"Ashikhmin & Shirley's", {phong}},
        {"Ashikhmin & Shirley's, brushed", {brushed(phong)}},
        {"diffuse", {diffuse}},
        {"glossy", {glossy}},
        {"metal", {metal}},
        {"dielectric", {dielectric}},
        {"glass from outside", {glass_in}},
        {"glass from inside", {glass_out}},
        {"diffuse, mapped normal", {diffuse_lobe(orange, tilted, up)}},
        {"glossy, mapped normal", {glossy_lobe(orange, tilted, 0.3f)}},
        {"glass, mapped normal", {glass_lobe(orange, orange, tilted, 0.4f, 1.45f)}},
        {"all", {straight, metal, glass_in, dielectric, diffuse, phong, brushed(glossy)}},
    };
    cases.insert(cases.end(), facets.begin(), facets.end());
    return cases;
}

Bsdf mixture(const Case& c, const V3f& wo)
{
    Bsdf bsdf(wo, up);
    for (const Lobe& lobe : c.lobes) {
        bsdf.add(lobe, lobe.weight + lobe.second_weight);
    }
    return bsdf;
}

class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    float next() { return uniform_(generator_); }
    std::optional<BsdfSample> sample(const Bsdf& bsdf)
    {
        const float u_lobe = next();
        const float x = next();
        return bsdf.sample(u_lobe, {x, next()});
    }

private:
    std::mt19937 generator_;
    std::uniform_real_distribution<float> uniform_{0.0f, 1.0f};
};

constexpr double view_angles_deg[] = {5.0, 50.0, 80.0};

TEST(Bsdf, samples_follow_the_density_of_evaluate)
{
    constexpr int heights = 20;
    constexpr int azimuths = 20;
    constexpr int sub = 12;  // quadrature points a cell and axis
    constexpr int samples = 200000;
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

TEST(Bsdf, a_glossy_toon_fills_its_cone_evenly)
{
    // Half angle 45 degrees, of which the outer 18 fade out; seen so that all of it is above the
    // surface.
    constexpr int bins = 20;
    constexpr int samples = 200000;
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

TEST(Bsdf, a_mixture_of_all_the_lobes_it_holds_loses_none)
{
    Bsdf bsdf(up, up);
    const Color3f share(1.0f / float(Bsdf::capacity));
    for (int i = 0; i < Bsdf::capacity; ++i) {
        bsdf.add(diffuse_lobe(share, up, up), share);
    }
    const Bsdf copy = bsdf;
    for (const Bsdf* one : {static_cast<const Bsdf*>(&bsdf), &copy}) {
        EXPECT_NEAR(one->evaluate(up).value.x, 1.0 / pi, 1e-6);
        EXPECT_NEAR(one->sample(0.999f, {0.2f, 0.3f})->weight.x, 1.0f, 1e-5f);
    }
}

TEST(Bsdf, the_weight_of_a_sample_is_its_value_over_its_density)
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

TEST(Bsdf, samples_average_to_the_integral_of_evaluate)
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

TEST(Bsdf, a_narrow_lobe_samples_with_bounded_weights)
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

TEST(Bsdf, reflection_is_reciprocal)
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
            kind == LobeKind::GlossyToon || kind == LobeKind::Velvet) {
            continue;
        }
        const Color3f ab = mixture(c, a).evaluate(b).value / b.z;
        const Color3f ba = mixture(c, b).evaluate(a).value / a.z;
        EXPECT_GT(ab.x, 0.0f) << c.name;
        EXPECT_LT((ab - ba).length(), 1e-5f * ab.length()) << c.name;
    }
}

TEST(Bsdf, transmission_is_reciprocal_as_basic_radiance)
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

TEST(Bsdf, lambert_returns_exactly_its_colour)
{
    Bsdf bsdf(direction_at(60.0), up);
    const Color3f color(0.9f, 0.5f, 0.2f);
    bsdf.add(diffuse_lobe(color, up, up), color);
    Random random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::optional<BsdfSample> s = random.sample(bsdf);
        if (s) {
            ASSERT_LT((s->weight - color).length(), 1e-6f);
        }
    }
    EXPECT_NEAR(test::integrate(bsdf).value.x, 0.9, 1e-4);
    EXPECT_EQ(bsdf.albedo(), color);
}

TEST(Bsdf, a_mirror_reflects_and_is_found_by_sampling_alone)
{
    Bsdf bsdf(direction_at(40.0), up);
    bsdf.add(glossy_lobe(Color3f(0.8f), up, 0.0f), Color3f(0.8f));
    EXPECT_TRUE(bsdf.is_delta_only());
    const std::optional<BsdfSample> s = bsdf.sample(0.3f, {0.2f, 0.9f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_delta);
    EXPECT_FALSE(s->is_straight);
    EXPECT_EQ(s->pdf, 0.0f);
    EXPECT_LT((s->wi - direction_at(40.0, 180.0)).length(), 1e-6f);
    EXPECT_LT((s->weight - Color3f(0.8f)).length(), 1e-6f);
    EXPECT_EQ(bsdf.evaluate(s->wi).value, Color3f(0.0f));
}

TEST(Bsdf, smooth_glass_refracts_by_snells_law_both_ways_without_loss)
{
    for (float ior : {1.5f, 1.0f / 1.5f}) {
        const double angle_deg = 30.0;
        Bsdf bsdf(direction_at(angle_deg), up);
        bsdf.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, 0.0f, ior), Color3f(1.0f));
        const double bent_deg = deg_from_rad(std::asin(std::sin(rad_from_deg(angle_deg)) / ior));
        const std::optional<BsdfSample> passed = bsdf.sample(0.999f, {0.5f, 0.5f});
        ASSERT_TRUE(passed);
        EXPECT_LT((passed->wi + direction_at(bent_deg)).length(), 1e-5f) << ior;
        EXPECT_NEAR(passed->weight.x, 1.0f, 1e-6f);
        const std::optional<BsdfSample> reflected = bsdf.sample(0.0f, {0.5f, 0.5f});
        ASSERT_TRUE(reflected);
        EXPECT_LT((reflected->wi - direction_at(angle_deg, 180.0)).length(), 1e-5f);
        EXPECT_NEAR(reflected->weight.x, 1.0f, 1e-6f);
    }
}

TEST(Bsdf, glass_in_glass_of_its_own_index_is_not_there)
{
    const V3f wo = direction_at(70.0, 20.0);
    for (float ior : {1.0f, 1.0002f, 0.9998f}) {
        Bsdf bsdf(wo, up);
        bsdf.add(glass_lobe(Color3f(1.0f), Color3f(1.0f), up, 0.5f, ior), Color3f(1.0f));
        EXPECT_TRUE(bsdf.is_delta_only());
        const std::optional<BsdfSample> s = bsdf.sample(0.9f, {0.3f, 0.3f});
        ASSERT_TRUE(s);
        EXPECT_LT((s->wi + wo).length(), 2e-3f) << ior;
    }
}

TEST(Bsdf, straight_light_passes_and_is_no_part_of_the_albedo)
{
    const V3f wo = direction_at(70.0, 20.0);
    Bsdf bsdf(wo, up);
    bsdf.add(straight_lobe(Color3f(0.25f)), Color3f(0.25f));
    bsdf.add(diffuse_lobe(Color3f(0.75f), up, up), Color3f(0.75f));
    EXPECT_FALSE(bsdf.is_delta_only());
    EXPECT_EQ(bsdf.albedo(), Color3f(0.75f));
    const std::optional<BsdfSample> s = bsdf.sample(0.2f, {0.3f, 0.3f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_delta && s->is_straight);
    EXPECT_EQ(s->wi, -wo);
    EXPECT_NEAR(s->weight.x, 1.0f, 1e-6f);
    const std::optional<BsdfSample> other = bsdf.sample(0.3f, {0.3f, 0.3f});
    ASSERT_TRUE(other);
    EXPECT_FALSE(other->is_straight);
    EXPECT_NEAR(other->weight.x, 1.0f, 1e-5f);
}

TEST(Bsdf, no_light_where_the_geometry_and_the_shading_normal_disagree)
{
    // Normal turned 60 degrees: below the geometry but above the shading normal, and the reverse.
    const V3f ns = direction_at(60.0);
    const V3f below_geometry = direction_at(110.0);
    const V3f below_shading = direction_at(80.0, 180.0);
    const Color3f white(1.0f);
    for (const Lobe& lobe :
         {diffuse_lobe(white, ns, up), glossy_lobe(white, ns, 0.5f),
          dielectric_lobe(white, ns, 0.5f, 1.5f), glass_lobe(white, white, ns, 0.5f, 1.5f)}) {
        Bsdf bsdf(direction_at(30.0), up);
        bsdf.add(lobe, white);
        for (const V3f& wi : {below_geometry, below_shading}) {
            EXPECT_EQ(bsdf.evaluate(wi).value, Color3f(0.0f)) << int(lobe.kind) << " " << wi;
            EXPECT_EQ(bsdf.evaluate(wi).pdf, 0.0f) << int(lobe.kind) << " " << wi;
        }
    }
}

TEST(Bsdf, a_lobe_without_albedo_is_left_out)
{
    Bsdf bsdf(up, up);
    bsdf.add(diffuse_lobe(Color3f(0.0f), up, up), Color3f(0.0f));
    bsdf.add(diffuse_lobe(Color3f(NAN), up, up), Color3f(NAN));
    EXPECT_TRUE(bsdf.is_delta_only());
    EXPECT_FALSE(bsdf.sample(0.5f, {0.5f, 0.5f}));
    EXPECT_FALSE(Bsdf().sample(0.5f, {0.5f, 0.5f}));
    EXPECT_EQ(Bsdf().evaluate(up).pdf, 0.0f);
}

}  // namespace
}  // namespace eye_render
