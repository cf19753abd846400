// A fibre of hair: what is conserved, where its lobes lie, and what its roughnesses mean. Its
// samples are tested with those of all lobes.

#include "shading/fibre_lobe.h"

#include "../base/chi_squared.h"
#include "scattering.h"
#include "shading/fibre_spread.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

const V3f along(1.0f, 0.0f, 0.0f);

Bsdf bsdf_of(const Fibre& fibre, const V3f& wo, const V3f& ng)
{
    Bsdf bsdf(wo, ng);
    const Lobe lobe = fibre_lobe(1.0f, fibre, along, ng);
    bsdf.add(lobe, fibre_albedo(lobe, wo).reflected + fibre_albedo(lobe, wo).transmitted);
    return bsdf;
}

// Seen from the side of the fibre's plane YZ, where the normal turns.
V3f normal_at(double gamma_deg)
{
    const double gamma = rad_from_deg(gamma_deg);
    return V3f(V3d(0.0, std::sin(gamma), std::cos(gamma)));
}

TEST(FibreLobe, a_clear_fibre_loses_no_light)
{
    for (const double gamma_deg : {0.0, 35.0, 75.0, 89.9}) {
        for (const double elevation_deg : {0.0, 30.0, 80.0}) {
            const V3f wo = test::direction_at(elevation_deg, 0.0);  // towards the tip
            const Lobe lobe = fibre_lobe(1.0f, {.tilt_rad = 0.06f}, along, normal_at(gamma_deg));
            const FibreAlbedo albedo = fibre_albedo(lobe, wo);
            EXPECT_NEAR(albedo.reflected.y + albedo.transmitted.y, 1.0f, 1e-5f)
                << gamma_deg << ", " << elevation_deg;
        }
    }
}

TEST(FibreLobe, a_clear_fibre_is_lost_in_a_white_furnace)
{
    for (const float roughness : {0.35f, 0.6f, 1.0f}) {
        for (const double gamma_deg : {0.0, 50.0, 80.0}) {
            const Fibre clear{.roughness = roughness,
                              .radial_roughness = roughness,
                              .gloss_roughness = 0.9f,
                              .tilt_rad = 0.035f};
            const Bsdf bsdf = bsdf_of(clear, test::direction_at(20.0, 0.0), normal_at(gamma_deg));
            const test::SphereIntegral all = test::integrate(bsdf);
            EXPECT_NEAR(all.value.x, 1.0, 2e-3) << roughness << ", " << gamma_deg;
            EXPECT_NEAR(all.pdf, 1.0, 2e-3) << roughness << ", " << gamma_deg;
        }
    }
}

TEST(FibreLobe, absorbs_what_passes_through_its_middle)
{
    // Twice the radius; seen from straight above R is ((n - 1) / (n + 1))^2.
    const Color3f absorption(0.1f, 0.5f, 2.0f);
    const Lobe lobe = fibre_lobe(1.0f, {.absorption = absorption, .ior = 1.5f}, along, test::up);
    const FibreAlbedo albedo = fibre_albedo(lobe, test::up);
    EXPECT_NEAR(albedo.reflected.x, 0.04f, 1e-6f);
    for (int c = 0; c < 3; ++c) {
        const float passed = std::exp(-2.0f * absorption[c]);
        EXPECT_NEAR(albedo.transmitted[c], 0.96f * 0.96f * passed / (1.0f - 0.04f * passed),
                    1e-5f);
    }
}

// The brightest direction among those in the plane across the fibre.
double brightest_turn_deg(const Bsdf& bsdf)
{
    double best = 0.0;
    float most = 0.0f;
    for (int turn_deg = -180; turn_deg < 180; ++turn_deg) {
        const float value = bsdf.evaluate(normal_at(turn_deg)).value.x;
        if (value > most) {
            most = value;
            best = turn_deg;
        }
    }
    return best;
}

TEST(FibreLobe, black_hair_mirrors_at_its_own_normal)
{
    const Fibre black{.absorption = Color3f(100.0f), .roughness = 0.1f, .radial_roughness = 0.2f};
    for (const double gamma_deg : {-40.0, 10.0, 60.0}) {
        const Bsdf bsdf = bsdf_of(black, test::up, normal_at(gamma_deg));
        EXPECT_NEAR(brightest_turn_deg(bsdf), 2.0 * gamma_deg, 1.01);
    }
}

TEST(FibreLobe, light_passes_as_snell_bends_it)
{
    // gamma_t = asin(sin(40) / 1.55), and light turns by 2 gamma_t - 2 gamma_o + 180 degrees.
    const Fibre clear{.roughness = 0.1f, .radial_roughness = 0.15f};
    const Bsdf bsdf = bsdf_of(clear, test::up, normal_at(40.0));
    const double gamma_t_deg = deg_from_rad(std::asin(std::sin(rad_from_deg(40.0)) / 1.55));
    EXPECT_NEAR(brightest_turn_deg(bsdf), -(2.0 * gamma_t_deg - 80.0 + 180.0), 1.01);
}

// Mean elevation of reflected light.
double mean_elevation_deg(float tilt_rad)
{
    const Fibre black{.absorption = Color3f(100.0f), .roughness = 0.15f, .tilt_rad = tilt_rad};
    const Bsdf bsdf = bsdf_of(black, test::up, test::up);
    double sum = 0.0;
    double weight = 0.0;
    test::for_each_direction(360, 180, [&](const V3f& wi, double solid_angle) {
        const double value = double(bsdf.evaluate(wi).value.x) * solid_angle;
        sum += value * deg_from_rad(std::asin(double(wi.x)));
        weight += value;
    });
    return sum / weight;
}

TEST(FibreLobe, scales_turn_what_is_reflected_towards_the_root_by_twice_their_tilt)
{
    EXPECT_NEAR(mean_elevation_deg(0.0f), 0.0, 0.05);
    EXPECT_NEAR(mean_elevation_deg(float(rad_from_deg(3.0))), -6.0, 0.3);
}

TEST(FibreLobe, spreads_integrate_to_one_however_narrow)
{
    for (const float variance : {5.5e-7f, 1e-4f, 0.05f, 0.3f, 6.0f, 100.0f}) {
        for (const float sine : {0.0f, 0.5f, -0.95f}) {
            const Elevation o = Elevation::of_sine(sine);
            double sum = 0.0;
            constexpr int steps = 400000;
            for (int i = 0; i < steps; ++i) {
                const double theta = ((i + 0.5) / steps - 0.5) * pi;
                const Elevation at{float(std::sin(theta)), float(std::cos(theta))};
                sum += double(along_density(at, o, variance)) * std::cos(theta) * pi / steps;
            }
            EXPECT_NEAR(sum, 1.0, 2e-3) << variance << ", " << sine;
        }
    }
    for (const float scale : {2e-4f, 0.1f, 4.3f}) {
        double sum = 0.0;
        constexpr int steps = 400000;
        for (int i = 0; i < steps; ++i) {
            const double phi = ((i + 0.5) / steps - 0.5) * 2.0 * pi;
            sum += double(around_density(float(phi), scale)) * 2.0 * pi / steps;
        }
        EXPECT_NEAR(sum, 1.0, 1e-3) << scale;
    }
}

TEST(FibreLobe, samples_along_it_are_spread_as_their_density_says)
{
    constexpr int bins = 200;
    constexpr int finer = 50;
    constexpr int samples = 1000000;
    const std::vector<float> variances{1e-3f, 0.05f, 1.0f, 20.0f};
    const double significance = 1.0 - std::pow(0.99, 1.0 / double(variances.size()));
    for (const float variance : variances) {
        const Elevation o = Elevation::of_sine(0.4f);
        std::vector<double> expected(bins), observed(bins);
        for (int i = 0; i < bins * finer; ++i) {
            const double sine = (i + 0.5) / (bins * finer) * 2.0 - 1.0;
            expected[std::size_t(i / finer)] +=
                double(along_density(Elevation::of_sine(float(sine)), o, variance)) * 2.0 *
                samples / (bins * finer);
        }
        std::mt19937 generator(3);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        for (int i = 0; i < samples; ++i) {
            const float u_drop = uniform(generator);
            const double sine = double(sample_along(u_drop, uniform(generator), o, variance).sine);
            ++observed[std::size_t(std::min(int((sine + 1.0) / 2.0 * bins), bins - 1))];
        }
        const test::ChiSquared fit = test::chi_squared_test(observed, expected, significance);
        EXPECT_LT(fit.statistic, fit.critical) << variance;
    }
}

}  // namespace
}  // namespace eye_render
