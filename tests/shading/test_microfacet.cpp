#include "../base/chi_squared.h"
#include "scattering.h"
#include "shading/microfacet.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

using test::direction_at;
using test::for_each_direction;

float density_at(const V3f& m, float alpha)
{
    return ggx_density(alpha * alpha, m.z * m.z, m.x * m.x + m.y * m.y);
}

// The density that sample_visible_normal claims.
double visible_density(const V3f& m, const V3f& wo, float alpha)
{
    const float masking = masking_over_cos(wo.z, smith_term(alpha * alpha, wo.z));
    return m.z > 0.0f ? double(density_at(m, alpha)) * std::max(0.0f, wo.dot(m)) * masking : 0.0;
}

TEST(Microfacet, facets_cover_the_surface_they_are_on)
{
    for (float alpha : {0.1f, 0.3f, 1.0f}) {
        double area = 0.0;
        for_each_direction(4096, 4, [&](const V3f& m, double solid_angle) {
            area += m.z > 0.0f ? double(density_at(m, alpha) * m.z) * solid_angle : 0.0;
        });
        EXPECT_NEAR(area, 1.0, 1e-3) << "alpha " << alpha;
    }
}

TEST(Microfacet, visible_facets_cover_what_the_viewer_sees)
{
    for (float alpha : {0.1f, 0.3f, 1.0f}) {
        for (double angle_deg : {0.0, 40.0, 80.0}) {
            const V3f wo = direction_at(angle_deg);
            double share = 0.0;
            for_each_direction(2048, 256, [&](const V3f& m, double solid_angle) {
                share += visible_density(m, wo, alpha) * solid_angle;
            });
            EXPECT_NEAR(share, 1.0, 2e-3) << "alpha " << alpha << ", " << angle_deg << " deg";
        }
    }
}

TEST(Microfacet, sampled_normals_follow_the_visible_density)
{
    constexpr int heights = 24;
    constexpr int azimuths = 16;
    constexpr int sub = 16;  // quadrature points a cell and axis
    constexpr int samples = 1000000;
    const struct {
        float alpha;
        double angle_deg;
    } cases[] = {{1.0f, 0.0}, {1.0f, 60.0}, {0.5f, 85.0}, {0.3f, 30.0}};
    const double significance = 1.0 - std::pow(1.0 - 0.01, 1.0 / double(std::size(cases)));

    for (const auto& c : cases) {
        const V3f wo = direction_at(c.angle_deg);
        const auto cell_of = [](const V3f& m) { return test::cell_of(m, heights, azimuths); };
        std::vector<double> expected(heights * azimuths), observed(heights * azimuths);
        for_each_direction(heights * sub, azimuths * sub, [&](const V3f& m, double cell) {
            if (m.z > 0.0f) {
                expected[cell_of(m)] += samples * visible_density(m, wo, c.alpha) * cell;
            }
        });
        std::mt19937 random(1);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        for (int i = 0; i < samples; ++i) {
            const V2f u(uniform(random), uniform(random));
            ++observed[cell_of(sample_visible_normal(wo, c.alpha, u))];
        }
        const test::ChiSquared fit = test::chi_squared_test(observed, expected, significance);
        EXPECT_LT(fit.statistic, fit.critical)
            << "alpha " << c.alpha << ", " << c.angle_deg << " deg";
    }
}

TEST(Microfacet, sampled_normals_are_unit_and_face_the_viewer_even_at_the_corners)
{
    constexpr float below_one = 0x1.fffffep-1f;
    for (float alpha : {smallest_rough_alpha, 0.2f, 1.0f}) {
        for (double angle_deg : {0.0, 60.0, 89.99, 89.99999}) {
            const V3f wo = direction_at(angle_deg, 33.0);
            for (float x : {0.0f, 0.5f, below_one}) {
                for (float y : {0.0f, 0.5f, below_one}) {
                    const V3f m = sample_visible_normal(wo, alpha, {x, y});
                    EXPECT_NEAR(m.length(), 1.0f, 1e-5f) << alpha << " " << wo << " " << V2f(x, y);
                    EXPECT_GE(m.z, 0.0f);
                    EXPECT_GE(m.dot(wo), -1e-6f) << alpha << " " << wo << " " << V2f(x, y);
                }
            }
        }
    }
}

// Both models, spread twice as widely one way as the other.
struct BrushedFacets {
    const char* name;
    float (*density)(float, float, const V3f&);
    float (*smith)(float, float, const V3f&);
    V3f (*sample)(const V3f&, float, float, const V2f&);

    static constexpr float alpha_x = 0.6f;
    static constexpr float alpha_y = 0.3f;

    [[nodiscard]] double visible_density(const V3f& m, const V3f& wo) const
    {
        const float masking = masking_over_cos(wo.z, smith(alpha_x, alpha_y, wo));
        return m.z > 0.0f ? double(density(alpha_x, alpha_y, m) * std::max(0.0f, wo.dot(m))) *
                                double(masking)
                          : 0.0;
    }
};

const BrushedFacets brushed_facets[] = {
    {"GGX", &ggx_density, &smith_term, &sample_visible_normal},
    {"Beckmann", &beckmann_density, &beckmann_smith_term, &sample_visible_beckmann_normal},
};

TEST(Microfacet, brushed_facets_cover_the_surface_and_what_the_viewer_sees)
{
    for (const BrushedFacets& facets : brushed_facets) {
        for (const V3f& wo : {direction_at(0.0), direction_at(50.0, 30.0), direction_at(80.0)}) {
            double area = 0.0;
            double seen = 0.0;
            for_each_direction(1024, 256, [&](const V3f& m, double solid_angle) {
                if (m.z > 0.0f) {
                    area += double(facets.density(0.6f, 0.3f, m) * m.z) * solid_angle;
                    seen += facets.visible_density(m, wo) * solid_angle;
                }
            });
            EXPECT_NEAR(area, 1.0, 2e-3) << facets.name;
            EXPECT_NEAR(seen, 1.0, 2e-3) << facets.name << ", " << wo;
        }
    }
}

TEST(Microfacet, brushed_facets_alike_both_ways_are_not_brushed)
{
    const V3f m = direction_at(20.0, 50.0);
    EXPECT_NEAR(ggx_density(0.4f, 0.4f, m), density_at(m, 0.4f), 1e-5f * density_at(m, 0.4f));
    EXPECT_NEAR(smith_term(0.4f, 0.4f, m), smith_term(0.16f, m.z), 1e-6f);
}

TEST(Microfacet, sampled_brushed_normals_follow_the_visible_density)
{
    constexpr int heights = 24;
    constexpr int azimuths = 16;
    constexpr int sub = 12;
    constexpr int samples = 1000000;
    constexpr std::size_t views = 2;
    const double significance =
        1.0 - std::pow(1.0 - 0.01, 1.0 / double(std::size(brushed_facets) * views));
    for (const BrushedFacets& facets : brushed_facets) {
        for (const V3f& wo : {direction_at(5.0, 10.0), direction_at(70.0, 40.0)}) {
            std::vector<double> expected(heights * azimuths), observed(heights * azimuths);
            for_each_direction(heights * sub, azimuths * sub, [&](const V3f& m, double cell) {
                expected[test::cell_of(m, heights, azimuths)] +=
                    samples * facets.visible_density(m, wo) * cell;
            });
            std::mt19937 random(11);
            std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
            for (int i = 0; i < samples; ++i) {
                const float x = uniform(random);
                const V3f m = facets.sample(wo, BrushedFacets::alpha_x, BrushedFacets::alpha_y,
                                            {x, uniform(random)});
                ++observed[test::cell_of(m, heights, azimuths)];
            }
            const test::ChiSquared fit = test::chi_squared_test(observed, expected, significance);
            EXPECT_LT(fit.statistic, fit.critical) << facets.name << ", " << wo;
        }
    }
}

}  // namespace
}  // namespace eye_render
