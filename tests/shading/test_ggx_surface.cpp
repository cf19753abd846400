// White furnaces: rough mirrors and rough glass in light from all around.

#include "scattering.h"
#include "shading/ggx_surface.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

constexpr float roughnesses[] = {0.3f, 0.5f, 0.75f, 1.0f};
constexpr double angles_deg[] = {0.0, 30.0, 60.0, 80.0};

GgxSurface surface_at(double angle_deg, float roughness, bool multiple_scattering = true)
{
    return {.normal = up,
            .cos_o = direction_at(angle_deg).z,
            .roughness = roughness,
            .multiple_scattering = multiple_scattering};
}

TEST(GgxSurface, a_white_mirror_of_any_roughness_returns_all_light)
{
    constexpr double table_error = 0.01;
    for (float roughness : roughnesses) {
        for (double angle_deg : angles_deg) {
            Bsdf bsdf(direction_at(angle_deg), up);
            add_glossy(bsdf, surface_at(angle_deg, roughness), Color3f(1.0f));
            EXPECT_NEAR(test::integrate(bsdf, 1024).value.x, 1.0, table_error)
                << "roughness " << roughness << ", " << angle_deg << " deg";
        }
    }
}

TEST(GgxSurface, single_scattering_loses_light_with_roughness)
{
    double previous = 1.0;
    for (float roughness : roughnesses) {
        Bsdf bsdf(up, up);
        add_glossy(bsdf, surface_at(0.0, roughness, false), Color3f(1.0f));
        const double albedo = test::integrate(bsdf, 1024).value.x;
        EXPECT_LT(albedo, previous);
        previous = albedo;
    }
    // With alpha 1 and seen from above, the lobe is c / (2 pi (1 + c)) for light under cosine c.
    EXPECT_NEAR(previous, 1.0 - std::log(2.0), 1e-4);
}

TEST(GgxSurface, white_glass_of_any_roughness_returns_all_light)
{
    constexpr double table_error = 0.02;
    for (float ior : {1.45f, 1.0f / 1.45f}) {
        for (float roughness : roughnesses) {
            for (double angle_deg : angles_deg) {
                Bsdf bsdf(direction_at(angle_deg), up);
                add_glass(bsdf, surface_at(angle_deg, roughness), 1.0f, Color3f(1.0f),
                          Color3f(1.0f), ior);
                EXPECT_NEAR(test::integrate(bsdf, 1024).value.x, 1.0, table_error)
                    << "roughness " << roughness << ", " << angle_deg << " deg, ior " << ior;
            }
        }
    }
}

TEST(GgxSurface, a_white_metal_is_a_white_mirror)
{
    for (double angle_deg : angles_deg) {
        Bsdf metal(direction_at(angle_deg), up);
        add_metal(metal, surface_at(angle_deg, 0.6f), 1.0f, Color3f(1.0f));
        Bsdf mirror(direction_at(angle_deg), up);
        add_glossy(mirror, surface_at(angle_deg, 0.6f), Color3f(1.0f));
        const V3f wi = direction_at(35.0, 160.0);
        EXPECT_NEAR(metal.evaluate(wi).value.x, mirror.evaluate(wi).value.x, 1e-6f);
    }
}

TEST(GgxSurface, a_mirror_finish_is_neither_compensated_nor_spread)
{
    Bsdf bsdf(direction_at(40.0), up);
    add_metal(bsdf, surface_at(40.0, 0.02f), 1.0f, Color3f(0.5f));
    EXPECT_TRUE(bsdf.is_delta_only());
    const std::optional<BsdfSample> s = bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    const float schlick = 0.5f + 0.5f * std::pow(1.0f - direction_at(40.0).z, 5.0f);
    EXPECT_NEAR(s->weight.x, schlick, 1e-5f);
}

TEST(GgxSurface, what_a_polish_keeps_from_below_is_what_it_reflects)
{
    // The layers' tables count facets, not shadowing, and their grid is coarse at grazing angles.
    constexpr double table_error = 0.02;
    for (float roughness : roughnesses) {
        for (double angle_deg : {0.0, 30.0, 60.0}) {
            Bsdf bsdf(direction_at(angle_deg), up);
            const float kept = add_dielectric(bsdf, surface_at(angle_deg, roughness), 1.0f, 1.5f);
            EXPECT_NEAR(test::integrate(bsdf, 1024).value.x, kept, table_error)
                << "roughness " << roughness << ", " << angle_deg << " deg";
            EXPECT_NEAR(bsdf.albedo().x, kept, 1e-6f);
        }
    }
}

TEST(GgxSurface, albedo_is_near_the_light_returned)
{
    const Color3f gold(1.0f, 0.77f, 0.34f);
    for (float roughness : {0.3f, 0.6f, 1.0f}) {
        Bsdf bsdf(direction_at(30.0), up);
        add_metal(bsdf, surface_at(30.0, roughness), 1.0f, gold);
        const V3d returned = test::integrate(bsdf, 1024).value;
        EXPECT_NEAR(bsdf.albedo().y, returned.y, 0.02) << roughness;
        EXPECT_NEAR(bsdf.albedo().z, returned.z, 0.02) << roughness;
    }
}

TEST(GgxSurface, colours_brighter_than_white_stay_finite)
{
    Bsdf bsdf(direction_at(30.0), up);
    add_glossy(bsdf, surface_at(30.0, 1.0f), Color3f(50.0f));
    add_glass(bsdf, surface_at(30.0, 1.0f), 1.0f, Color3f(50.0f), Color3f(50.0f), 1.5f);
    const Color3f value = bsdf.evaluate(direction_at(10.0)).value;
    EXPECT_TRUE(test::is_finite(value) && value.x > 0.0f) << value;
}

}  // namespace
}  // namespace eye_render
