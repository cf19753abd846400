#include "scattering.h"
#include "shading/energy_tables.h"
#include "shading/fresnel.h"
#include "shading/microfacet.h"

#include <gtest/gtest.h>

#include <random>

namespace eye_render {
namespace {

using test::up;

V3f viewer(float cos_o) { return {std::sqrt(1.0f - cos_o * cos_o), 0.0f, cos_o}; }

double albedo_by_integration(const Lobe& lobe, float cos_o)
{
    Bsdf bsdf(viewer(cos_o), up);
    bsdf.add(lobe, Color3f(1.0f));
    return test::integrate(bsdf, 1024).value.x;
}

// Nodes of the tables, so that only their values are judged and not the interpolation.
constexpr float rough_nodes[] = {8.0f / 15.0f, 12.0f / 15.0f, 1.0f};
constexpr float cos_nodes[] = {2.0f / 15.0f, 8.0f / 15.0f, 1.0f};
constexpr float quadrature_error = 3e-3f;

TEST(EnergyTables, reflection_agrees_with_integration_over_all_directions)
{
    for (float roughness : {15.0f / 31.0f, 23.0f / 31.0f, 1.0f}) {
        for (float cos_o : {4.0f / 31.0f, 16.0f / 31.0f, 1.0f}) {
            const Lobe lobe = glossy_lobe(Color3f(1.0f), up, roughness * roughness);
            EXPECT_NEAR(reflection_energy(roughness, cos_o).albedo,
                        albedo_by_integration(lobe, cos_o), quadrature_error)
                << "roughness " << roughness << ", cos " << cos_o;
        }
    }
}

TEST(EnergyTables, glass_agrees_with_integration_over_all_directions)
{
    const float parameter = 7.0f / 15.0f;
    const float dense = ior_from_f0(std::pow(parameter, 4.0f));
    for (float ior : {dense, 1.0f / dense}) {
        for (float roughness : rough_nodes) {
            for (float cos_o : cos_nodes) {
                const Lobe lobe =
                    glass_lobe(Color3f(1.0f), Color3f(1.0f), up, roughness * roughness, ior);
                EXPECT_NEAR(glass_energy(roughness, cos_o, ior).albedo,
                            albedo_by_integration(lobe, cos_o), quadrature_error)
                    << "roughness " << roughness << ", cos " << cos_o << ", ior " << ior;
            }
        }
    }
}

TEST(EnergyTables, mean_albedo_is_the_albedo_averaged_over_cosine)
{
    for (float roughness : {0.2f, 0.5f, 1.0f}) {
        double reflection = 0.0;
        double glass = 0.0;
        constexpr int steps = 2000;
        for (int i = 0; i < steps; ++i) {
            const float mu = (float(i) + 0.5f) / steps;
            reflection += double(2.0f * mu * reflection_energy(roughness, mu).albedo) / steps;
            glass += double(2.0f * mu * glass_energy(roughness, mu, 1.45f).albedo) / steps;
        }
        EXPECT_NEAR(reflection_energy(roughness, 1.0f).mean_albedo, reflection, 1e-4);
        EXPECT_NEAR(glass_energy(roughness, 1.0f, 1.45f).mean_albedo, glass, 1e-4);
    }
}

TEST(EnergyTables, blends_are_the_mean_fresnel_of_the_facets_seen)
{
    std::mt19937 random(2);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const float parameter = 7.0f / 15.0f;
    const float ior = ior_from_f0(std::pow(parameter, 4.0f));
    constexpr int samples = 200000;
    for (float roughness : rough_nodes) {
        for (float cos_o : cos_nodes) {
            double dielectric = 0.0;
            double schlick = 0.0;
            for (int i = 0; i < samples; ++i) {
                const V3f wo = viewer(cos_o);
                const V3f m = sample_visible_normal(wo, roughness * roughness,
                                                    {uniform(random), uniform(random)});
                const float cos_facet = std::min(1.0f, wo.dot(m));
                if (2.0f * cos_facet * m.z - wo.z > 0.0f) {
                    const float f0 = f0_from_ior(ior);
                    const float f = fresnel_dielectric(cos_facet, ior).reflectance;
                    dielectric += double((f - f0) / (1.0f - f0)) / samples;
                    schlick += double(schlick_blend(cos_facet)) / samples;
                }
            }
            EXPECT_NEAR(dielectric_albedo_blend(roughness, cos_o, ior), dielectric, 2e-3)
                << "roughness " << roughness << ", cos " << cos_o;
            EXPECT_NEAR(schlick_albedo_blend(roughness, cos_o), schlick, 2e-3)
                << "roughness " << roughness << ", cos " << cos_o;
        }
    }
}

// Rows of table_ggx_E, table_ggx_Eavg and table_ggx_gen_schlick_ior_s of Blender's
// intern/cycles/scene/shader.tables, at nodes and, for the last, interpolated at ior 1.5.
TEST(EnergyTables, agree_with_those_of_cycles)
{
    constexpr float tolerance = 1e-3f;
    EXPECT_NEAR(reflection_energy(1.0f, 1.0f).albedo, 0.306853f, tolerance);
    EXPECT_NEAR(reflection_energy(16.0f / 31.0f, 1.0f).albedo, 0.899f, 5e-3f);
    EXPECT_NEAR(reflection_energy(15.0f / 31.0f, 1.0f / 31.0f).albedo, 0.952526f, tolerance);
    EXPECT_NEAR(reflection_energy(1.0f, 0.5f).mean_albedo, 0.409137f, tolerance);
    EXPECT_NEAR(reflection_energy(16.0f / 31.0f, 0.5f).mean_albedo, 0.870874f, tolerance);

    const float expected[3][4] = {{0.0000f, 0.0117f, 0.0955f, 0.5628f},
                                  {0.0006f, 0.0138f, 0.0639f, 0.1705f},
                                  {0.0014f, 0.0058f, 0.0161f, 0.0403f}};
    const float cosines[] = {1.0f, 0.7f, 0.4f, 0.1f};
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 4; ++c) {
            EXPECT_NEAR(dielectric_albedo_blend(0.5f * float(r), cosines[c], 1.5f), expected[r][c],
                        tolerance)
                << "roughness " << 0.5f * float(r) << ", cos " << cosines[c];
        }
    }
}

TEST(EnergyTables, no_boundary_loses_light_between_equal_indices)
{
    EXPECT_NEAR(glass_energy(1.0f, 0.5f, 1.0f).albedo, 1.0f, 1e-6f);
}

TEST(EnergyTables, a_smooth_lobe_needs_no_compensation_and_grazing_views_stay_finite)
{
    EXPECT_NEAR(energy_compensation(reflection_energy(0.0f, 0.3f), Color3f(1.0f)).x, 1.0f, 1e-4f);
    for (float cos_o : {0.0f, 1e-6f, -1.0f, NAN}) {
        const Color3f c = energy_compensation(reflection_energy(1.0f, cos_o), Color3f(1.0f));
        EXPECT_TRUE(test::is_finite(c)) << cos_o;
        EXPECT_GE(c.x, 1.0f) << cos_o;
    }
}

TEST(EnergyTables, compensation_of_a_colour_is_more_saturated_than_of_white)
{
    const LobeEnergy energy = reflection_energy(1.0f, 0.5f);
    const Color3f c = energy_compensation(energy, Color3f(1.0f, 0.5f, 0.0f));
    EXPECT_NEAR(c.x, 1.0f / energy.albedo, 1e-4f);
    EXPECT_LT(c.y, 0.5f * (c.x + 1.0f));
    EXPECT_EQ(c.z, 1.0f);
}

}  // namespace
}  // namespace eye_render
