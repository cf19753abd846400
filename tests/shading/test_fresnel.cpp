#include "base/units.h"
#include "shading/fresnel.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

constexpr float rounding = 2e-6f;

TEST(Fresnel, glass_reflects_four_percent_at_normal_incidence)
{
    EXPECT_NEAR(fresnel_dielectric(1.0f, 1.5f).reflectance, 0.04f, rounding);
    EXPECT_NEAR(f0_from_ior(1.5f), 0.04f, rounding);
    EXPECT_NEAR(f0_from_ior(1.0f / 1.5f), 0.04f, rounding);
}

TEST(Fresnel, everything_is_reflected_at_grazing_incidence)
{
    EXPECT_NEAR(fresnel_dielectric(0.0f, 1.5f).reflectance, 1.0f, rounding);
    EXPECT_EQ(schlick_blend(0.0f), 1.0f);
}

TEST(Fresnel, half_of_the_light_is_polarised_away_at_brewsters_angle)
{
    // There p is not reflected at all and s is ((n^2 - 1) / (n^2 + 1))^2.
    const float ior = 1.5f;
    const float cos_brewster = 1.0f / std::sqrt(1.0f + ior * ior);
    const float s = std::pow((ior * ior - 1.0f) / (ior * ior + 1.0f), 2.0f);
    EXPECT_NEAR(fresnel_dielectric(cos_brewster, ior).reflectance, 0.5f * s, rounding);
}

TEST(Fresnel, reflection_is_total_beyond_the_critical_angle_and_only_there)
{
    const float ior = 1.0f / 1.5f;
    const float cos_critical = std::sqrt(1.0f - ior * ior);
    EXPECT_EQ(fresnel_dielectric(cos_critical - 1e-3f, ior).reflectance, 1.0f);
    EXPECT_EQ(fresnel_dielectric(cos_critical - 1e-3f, ior).cos_transmitted, 0.0f);
    EXPECT_LT(fresnel_dielectric(cos_critical + 1e-3f, ior).reflectance, 1.0f);
}

TEST(Fresnel, is_the_same_from_both_sides_along_one_ray)
{
    for (float cos_incident : {0.05f, 0.3f, 0.7f, 1.0f}) {
        const DielectricFresnel in = fresnel_dielectric(cos_incident, 1.5f);
        const DielectricFresnel out = fresnel_dielectric(in.cos_transmitted, 1.0f / 1.5f);
        EXPECT_NEAR(in.reflectance, out.reflectance, 1e-4f) << cos_incident;
        EXPECT_NEAR(out.cos_transmitted, cos_incident, 1e-4f) << cos_incident;
    }
}

TEST(Fresnel, index_and_reflectance_are_inverse)
{
    for (float ior : {1.0f, 1.33f, 1.5f, 2.4f, 10.0f}) {
        EXPECT_NEAR(ior_from_f0(f0_from_ior(ior)), ior, 1e-4f * ior);
    }
    EXPECT_TRUE(std::isfinite(ior_from_f0(1.0f)));
}

TEST(Fresnel, means_agree_with_the_integral_over_the_hemisphere)
{
    constexpr float fit_error = 0.006f;  // Kulla & Conty's fits are of plotting accuracy
    const auto mean = [](auto&& f) {
        constexpr int steps = 10000;
        double sum = 0.0;
        for (int i = 0; i < steps; ++i) {
            const double mu = (i + 0.5) / steps;
            sum += 2.0 * mu * double(f(float(mu))) / steps;
        }
        return float(sum);
    };
    for (float ior : {0.5f, 0.667f, 0.9f, 1.1f, 1.33f, 1.5f, 2.0f}) {
        EXPECT_NEAR(mean_fresnel_dielectric(ior),
                    mean([&](float mu) { return fresnel_dielectric(mu, ior).reflectance; }),
                    fit_error)
            << ior;
    }
    EXPECT_NEAR(mean_schlick_blend, mean(schlick_blend), 1e-5f);
}

}  // namespace
}  // namespace eye_render
