// White furnaces: rough mirrors and rough glass in light from all around.

#include "scattering.h"
#include "shading/ggx_surface.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

const Color3f white(1.0f);

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
            add_glossy(bsdf, surface_at(angle_deg, roughness), 1.0f, Color3f(1.0f));
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
        add_glossy(bsdf, surface_at(0.0, roughness, false), 1.0f, Color3f(1.0f));
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
                add_glass(bsdf, surface_at(angle_deg, roughness), white, white, white,
                          {.ior = ior});
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
        add_metal(metal, surface_at(angle_deg, 0.6f), white, white, white);
        Bsdf mirror(direction_at(angle_deg), up);
        add_glossy(mirror, surface_at(angle_deg, 0.6f), 1.0f, white);
        const V3f wi = direction_at(35.0, 160.0);
        EXPECT_NEAR(metal.evaluate(wi).value.x, mirror.evaluate(wi).value.x, 1e-6f);
    }
}

TEST(GgxSurface, a_mirror_finish_is_neither_compensated_nor_spread)
{
    Bsdf bsdf(direction_at(40.0), up);
    add_metal(bsdf, surface_at(40.0, 0.02f), white, Color3f(0.5f), white);
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
            const float kept =
                add_dielectric(bsdf, surface_at(angle_deg, roughness), white, {.ior = 1.5f});
            EXPECT_NEAR(test::integrate(bsdf, 1024).value.x, kept, table_error)
                << "roughness " << roughness << ", " << angle_deg << " deg";
            EXPECT_NEAR(bsdf.albedo().x, kept, 1e-6f);
        }
    }
}

// Of a surface that is brushed this strongly, along a direction that no axis is near.
GgxSurface brushed_at(double angle_deg, float roughness, float stretch)
{
    GgxSurface surface = surface_at(angle_deg, roughness);
    brush(surface, stretch, 1.0f / stretch, V3f(1.0f, 0.4f, 0.0f), 0.1f, up);
    return surface;
}

TEST(GgxSurface, brushed_by_nothing_it_is_the_unbrushed_one_exactly)
{
    for (double angle_deg : angles_deg) {
        Bsdf plain(direction_at(angle_deg), up);
        add_metal(plain, surface_at(angle_deg, 0.4f), white, Color3f(0.7f), Color3f(0.8f));
        Bsdf brushed(direction_at(angle_deg), up);
        add_metal(brushed, brushed_at(angle_deg, 0.4f, 1.0f), white, Color3f(0.7f), Color3f(0.8f));
        const V3f wi = direction_at(35.0, 160.0);
        EXPECT_EQ(brushed.evaluate(wi).value, plain.evaluate(wi).value) << angle_deg;
    }
}

TEST(GgxSurface, a_brushed_mirror_spreads_light_across_the_brush)
{
    // Narrow along the tangent, which is at 36 degrees from the x axis after its turn.
    GgxSurface surface = surface_at(0.0, 0.5f);
    brush(surface, 0.3f, 1.0f / 0.3f, V3f(1.0f, 0.0f, 0.0f), 0.1f, up);
    Bsdf bsdf(up, up);
    add_glossy(bsdf, surface, 1.0f, white);
    const float along = bsdf.evaluate(direction_at(40.0, 36.0)).value.x;
    const float across = bsdf.evaluate(direction_at(40.0, 126.0)).value.x;
    EXPECT_GT(across, 10.0f * along);
    EXPECT_NEAR(along, bsdf.evaluate(direction_at(40.0, 216.0)).value.x, 1e-4f * along);
}

TEST(GgxSurface, a_coat_keeps_what_a_smooth_boundary_reflects)
{
    // Seen from above, 4 % at index 1.5; at Brewster's angle half of what is polarised across.
    for (const auto& [angle_deg, reflectance] : {std::pair(0.0, 0.04), std::pair(56.31, 0.074)}) {
        Bsdf bsdf(direction_at(angle_deg), up);
        EXPECT_NEAR(add_coat(bsdf, surface_at(angle_deg, 0.2f, false), white, 1.5f), reflectance,
                    2e-4);
    }
}

TEST(GgxSurface, a_conductor_reflects_by_its_index_and_extinction)
{
    // Normal incidence: ((n - 1)^2 + k^2) / ((n + 1)^2 + k^2). Silver at 650 nm: 0.14 + 4.1 i.
    Bsdf bsdf(up, up);
    add_conductor(bsdf, surface_at(0.0, 0.0f), 1.0f, Color3f(0.14f), Color3f(4.1f));
    const auto s = bsdf.sample(0.5f, {0.5f, 0.5f});
    ASSERT_TRUE(s);
    EXPECT_NEAR(s->weight.x, (0.86 * 0.86 + 4.1 * 4.1) / (1.14 * 1.14 + 4.1 * 4.1), 1e-5);
}

TEST(GgxSurface, the_edge_tint_of_a_metal_is_seen_near_82_degrees_alone)
{
    const double tinted_deg = std::acos(1.0 / 7.0) * 180.0 / pi;
    const Color3f tint(0.25f);
    for (const double angle_deg : {0.0, tinted_deg}) {
        const auto mirrored = [&](const Color3f& edge_tint) {
            Bsdf bsdf(direction_at(angle_deg), up);
            add_metal(bsdf, surface_at(angle_deg, 0.0f), white, Color3f(0.6f), edge_tint);
            return bsdf.sample(0.5f, {0.5f, 0.5f})->weight.x;
        };
        const float expected = angle_deg == 0.0 ? 1.0f : 0.25f;
        EXPECT_NEAR(mirrored(tint) / mirrored(white), expected, 1e-4f) << angle_deg;
    }
}

TEST(GgxSurface, a_tinted_boundary_reflects_the_tint_from_above_and_white_at_grazing)
{
    const Color3f blue(0.1f, 0.3f, 0.9f);
    const auto mirrored = [&](double angle_deg) {
        Bsdf bsdf(direction_at(angle_deg), up);
        static_cast<void>(add_dielectric(bsdf, surface_at(angle_deg, 0.0f), white,
                                         {.ior = 1.5f, .specular_tint = blue}));
        return bsdf.sample(0.5f, {0.5f, 0.5f})->weight;
    };
    EXPECT_LT((mirrored(0.0) - blue * 0.04f).length(), 1e-5f);
    EXPECT_GT(mirrored(89.9).x, 0.98f);
}

TEST(GgxSurface, albedo_is_near_the_light_returned)
{
    const Color3f gold(1.0f, 0.77f, 0.34f);
    for (float roughness : {0.3f, 0.6f, 1.0f}) {
        Bsdf bsdf(direction_at(30.0), up);
        add_metal(bsdf, surface_at(30.0, roughness), white, gold, white);
        const V3d returned = test::integrate(bsdf, 1024).value;
        EXPECT_NEAR(bsdf.albedo().y, returned.y, 0.02) << roughness;
        EXPECT_NEAR(bsdf.albedo().z, returned.z, 0.02) << roughness;
    }
}

TEST(GgxSurface, colours_brighter_than_white_stay_finite)
{
    Bsdf bsdf(direction_at(30.0), up);
    add_glossy(bsdf, surface_at(30.0, 1.0f), 1.0f, Color3f(50.0f));
    add_glass(bsdf, surface_at(30.0, 1.0f), white, Color3f(50.0f), Color3f(50.0f), {.ior = 1.5f});
    const Color3f value = bsdf.evaluate(direction_at(10.0)).value;
    EXPECT_TRUE(test::is_finite(value) && value.x > 0.0f) << value;
}

}  // namespace
}  // namespace eye_render
