// Rough Lambert, translucency and toon.

#include "lobe_cases.h"
#include "scattering.h"
#include "shading/diffuse_lobe.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

using test::direction_at;
using test::up;

const Color3f white(1.0f);
constexpr double angles_deg[] = {0.0, 30.0, 60.0, 85.0};

Bsdf oren_nayar(const Color3f& color, float roughness, double angle_deg)
{
    Bsdf bsdf(direction_at(angle_deg), up);
    const LobeAndAlbedo made =
        oren_nayar_lobe(color, color, roughness, up, up, direction_at(angle_deg));
    bsdf.add(made.lobe, made.albedo);
    return bsdf;
}

TEST(OrenNayar, white_returns_all_light_however_rough)
{
    for (float roughness : {0.2f, 0.6f, 1.0f}) {
        for (double angle_deg : angles_deg) {
            EXPECT_NEAR(test::integrate(oren_nayar(white, roughness, angle_deg)).value.x, 1.0,
                        2e-3)
                << roughness << ", " << angle_deg << " deg";
        }
    }
}

TEST(OrenNayar, albedo_is_the_light_returned)
{
    const Color3f orange(0.9f, 0.5f, 0.2f);
    for (float roughness : {0.2f, 1.0f}) {
        for (double angle_deg : angles_deg) {
            const Bsdf bsdf = oren_nayar(orange, roughness, angle_deg);
            const V3d returned = test::integrate(bsdf).value;
            for (int c = 0; c < 3; ++c) {
                EXPECT_NEAR(returned[c], double(bsdf.albedo()[c]), 2e-3) << roughness;
            }
        }
    }
}

TEST(OrenNayar, becomes_lambert_as_roughness_goes)
{
    Bsdf lambert(direction_at(60.0), up);
    lambert.add(diffuse_lobe(white, up, up), white);
    const V3f wi = direction_at(70.0, 20.0);
    EXPECT_NEAR(oren_nayar(white, 1e-4f, 60.0).evaluate(wi).value.x, lambert.evaluate(wi).value.x,
                1e-4f);
}

// What the light scattered more than once adds is a quotient of two losses that vanish with the
// roughness.
TEST(OrenNayar, is_smooth_down_to_no_roughness_at_all)
{
    const Color3f grey(0.6f);
    Bsdf lambert(direction_at(60.0), up);
    lambert.add(diffuse_lobe(grey, up, up), grey);
    const V3f wi = direction_at(70.0, 20.0);
    const float smooth = lambert.evaluate(wi).value.x;
    for (const float roughness : {0.0f, 1e-9f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f}) {
        const Bsdf rough = oren_nayar(grey, roughness, 60.0);
        // It grows by 1.3 of the smooth value a unit of roughness.
        EXPECT_NEAR(rough.evaluate(wi).value.x, smooth, (2.0f * roughness + 1e-6f) * smooth)
            << roughness;
        EXPECT_NEAR(rough.albedo().x, 0.6f, roughness + 1e-6f) << roughness;
    }
}

TEST(OrenNayar, is_flatter_than_lambert_against_the_light)
{
    // The full moon: a rough ball seen from where the light is does not darken towards its rim.
    const V3f grazing = direction_at(75.0);
    const float rough = oren_nayar(white, 1.0f, 75.0).evaluate(grazing).value.x;
    const float lambert = grazing.z / float(pi);
    EXPECT_GT(rough, 1.3f * lambert);
}

TEST(Translucent, is_lambert_on_the_other_side)
{
    Bsdf bsdf(direction_at(40.0), up);
    bsdf.add(translucent_lobe(white, up, up), white);
    EXPECT_TRUE(bsdf.transmits());
    EXPECT_EQ(bsdf.evaluate(direction_at(20.0)).value, Color3f(0.0f));
    EXPECT_NEAR(bsdf.evaluate(direction_at(120.0)).value.x, 0.5 / pi, 1e-6);
    const auto s = bsdf.sample(0.5f, {0.3f, 0.7f});
    ASSERT_TRUE(s);
    EXPECT_TRUE(s->is_transmitted && s->is_diffuse);
}

TEST(Toon, is_lit_within_its_cone_alone_and_fades_over_its_edge)
{
    // Half a right angle, and a fifth more to fade.
    Bsdf bsdf(direction_at(80.0), up);
    bsdf.add(toon_lobe(LobeKind::DiffuseToon, white, 0.5f, 0.2f, up, up), white);
    const float full = bsdf.evaluate(up).value.x;
    EXPECT_NEAR(bsdf.evaluate(direction_at(44.0, 130.0)).value.x, full, 1e-6f);
    EXPECT_NEAR(bsdf.evaluate(direction_at(54.0, 200.0)).value.x, 0.5f * full, 1e-4f);
    EXPECT_EQ(bsdf.evaluate(direction_at(64.0)).value.x, 0.0f);
}

TEST(Toon, a_cone_however_narrow_returns_what_is_drawn_from_it)
{
    // In a float the cosines of such angles are all rounding, in one way or another by the normal.
    for (double angle_deg = 3.0; angle_deg < 90.0; angle_deg += 9.0) {
        const V3f normal = direction_at(angle_deg, 5.0 * angle_deg);
        for (const float size : {0.0f, 1e-4f, 1e-2f}) {
            Bsdf bsdf(normal, normal);
            bsdf.add(toon_lobe(LobeKind::DiffuseToon, white, size, 0.0f, normal, normal), white);
            test::Random random(2);
            int lit = 0;
            for (int i = 0; i < 100; ++i) {
                const std::optional<BsdfSample> s = random.sample(bsdf);
                lit += s && std::abs(s->weight.x - 1.0f) < 1e-3f ? 1 : 0;
            }
            EXPECT_GT(lit, 90) << size << ", " << normal << ": on the rim rounding decides";
        }
    }
}

}  // namespace
}  // namespace eye_render
