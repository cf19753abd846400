// The medium below a surface, against van de Hulst's reflectance of a half space, and how light
// enters it.

#include "shading/subsurface.h"

#include "base/sobol.h"
#include "shading/burley_profile.h"
#include "shading/node.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

const V3f up(0.0f, 0.0f, 1.0f);

// Of light from all around, by a half space: van de Hulst 1980, "Multiple Light Scattering", in
// the form of d'Eon's "A Hitchhiker's Guide to Multiple Scattering", good to 0.002.
double half_space_albedo(double albedo, double anisotropy)
{
    const double s = std::sqrt((1.0 - albedo) / (1.0 - anisotropy * albedo));
    return (1.0 - s) * (1.0 - 0.139 * s) / (1.0 + 1.17 * s);
}

// Within what the fit misses: next to nothing up to a color of 0.7, a tenth where light is
// scattered hundreds of times.
TEST(SubsurfaceMedium, half_space_has_the_color_that_was_asked_for)
{
    for (const float anisotropy : {0.0f, 0.3f, 0.6f}) {
        for (const float color : {0.05f, 0.1f, 0.3f, 0.5f, 0.7f, 0.9f, 0.97f}) {
            const double albedo =
                static_cast<double>(legacy_single_scattering_albedo(color, anisotropy));
            EXPECT_NEAR(half_space_albedo(albedo, static_cast<double>(anisotropy)),
                        static_cast<double>(color), color > 0.7f ? 0.1 : 0.015)
                << "color " << color << ", anisotropy " << anisotropy;
        }
    }
    EXPECT_EQ(legacy_single_scattering_albedo(0.0f, 0.0f), 0.0f);
    EXPECT_GT(legacy_single_scattering_albedo(1.0f, 0.0f), 0.9999f);
}

TEST(SubsurfaceMedium, half_space_of_the_newer_walk_has_its_color_at_any_anisotropy)
{
    constexpr double rounding_of_fit = 1e-3;
    for (const float anisotropy : {-0.9f, 0.0f, 0.35f, 0.9f}) {
        for (const float color : {0.0f, 0.05f, 0.5f, 0.9f, 0.97f}) {
            const double albedo = static_cast<double>(single_scattering_albedo(color, anisotropy));
            EXPECT_NEAR(half_space_albedo(albedo, static_cast<double>(anisotropy)),
                        static_cast<double>(color), rounding_of_fit)
                << "color " << color << ", anisotropy " << anisotropy;
        }
    }
}

Lobe lobe_of(LobeKind method, const Color3f& color, float radius, float anisotropy = 0.0f)
{
    Lobe lobe = plain_lobe(method, color, up, 0.25f);
    lobe.f0 = color;
    lobe.edge = Color3f(radius);
    lobe.ior = 1.4f;
    lobe.a = anisotropy;
    return lobe;
}

TEST(SubsurfaceMedium, color_comes_of_the_medium_and_not_of_the_lobe)
{
    for (const float color : {0.02f, 0.1f, 0.8f}) {
        for (const LobeKind method : {LobeKind::RandomWalk, LobeKind::RandomWalkLegacy}) {
            const SubsurfaceMedium medium =
                subsurface_medium(lobe_of(method, Color3f(color), 1.0f));
            // One scattering takes the same, whether in the medium or where light enters it.
            EXPECT_NEAR(medium.entering.x * color * medium.albedo.x,
                        method == LobeKind::RandomWalk
                            ? single_scattering_albedo(color, 0.0f)
                            : legacy_single_scattering_albedo(color, 0.0f),
                        1e-6f);
            EXPECT_GE(medium.albedo.x, least_walk_albedo);
        }
    }
    EXPECT_EQ(subsurface_medium(lobe_of(LobeKind::RandomWalk, Color3f(0.0f), 1.0f)).entering.x,
              0.0f);
}

// The reduced extinction is what diffusion is of.
TEST(SubsurfaceMedium, light_goes_as_far_however_it_is_scattered)
{
    EXPECT_FLOAT_EQ(
        subsurface_medium(lobe_of(LobeKind::RandomWalk, Color3f(0.9f), 2.0f)).extinction.x, 0.5f);
    const SubsurfaceMedium even =
        subsurface_medium(lobe_of(LobeKind::RandomWalkLegacy, Color3f(0.9f), 2.0f));
    EXPECT_FLOAT_EQ(even.extinction.x, 2.0f * std::numbers::pi_v<float>);
    const SubsurfaceMedium forward =
        subsurface_medium(lobe_of(LobeKind::RandomWalkLegacy, Color3f(0.9f), 2.0f, 0.8f));
    const SubsurfaceMedium reduced = even_medium(forward);
    EXPECT_EQ(reduced.anisotropy, 0.0f);
    // What is absorbed stays, and of what is scattered the part that goes on is gone.
    EXPECT_NEAR(reduced.extinction.x * (1.0f - reduced.albedo.x),
                forward.extinction.x * (1.0f - forward.albedo.x), 1e-4f);
    EXPECT_NEAR(reduced.extinction.x * reduced.albedo.x,
                forward.extinction.x * forward.albedo.x * 0.2f, 1e-4f);
}

// Jensen's dipole at its ends: nothing is scattered in black skin, all in white.
TEST(SubsurfaceMedium, light_dies_away_in_skin_over_its_radius)
{
    const auto extinction = [](float color) {
        return subsurface_medium(lobe_of(LobeKind::RandomWalkSkin, Color3f(color), 2.0f))
            .extinction.x;
    };
    EXPECT_NEAR(extinction(0.0f), 1.0f / (2.0f * std::sqrt(3.0f)), 1e-5f);
    EXPECT_GT(extinction(1.0f), 100.0f * extinction(0.0f));
    EXPECT_GT(extinction(0.8f), extinction(0.5f));
}

TEST(SubsurfaceMedium, light_enters_by_snells_law_or_as_lambert_has_it)
{
    const V3f wo = V3f(0.8f, 0.0f, 0.6f);
    Lobe smooth = lobe_of(LobeKind::RandomWalk, Color3f(0.5f), 1.0f);
    smooth.alpha_x = 0.0f;
    const V3f wi = sample_entry(smooth, wo, 0.7f, V2f(0.3f, 0.6f));
    EXPECT_NEAR(wi.x, -0.8f / 1.4f, 1e-5f);
    EXPECT_LT(wi.z, 0.0f);
    EXPECT_NEAR(wi.length(), 1.0f, 1e-5f);

    const Lobe skin = lobe_of(LobeKind::RandomWalkSkin, Color3f(0.5f), 1.0f);
    constexpr int count = 4096;
    double cosine = 0.0;
    for (std::uint32_t i = 0; i < count; ++i) {
        const auto u = sobol_4d(3, i, 0);
        cosine -= static_cast<double>(sample_entry(skin, wo, 0.2f, V2f(u[0], u[1])).z) / count;
    }
    EXPECT_NEAR(cosine, 2.0 / 3.0, 1e-3);  // Lambert's mean
}

TEST(BurleyProfile, distances_are_spread_as_their_density_says)
{
    constexpr int count = 1 << 16;
    constexpr int cells = 64;
    constexpr double scale = 0.3;
    constexpr double end = scale * static_cast<double>(burley_cutoff);
    std::array<double, cells> found{};
    for (int i = 0; i < count; ++i) {
        const double r = static_cast<double>(
            sample_burley_distance(float(scale), (static_cast<float>(i) + 0.5f) / count));
        ASSERT_TRUE(r >= 0.0 && r <= end * 1.0001) << r;
        found[std::min(static_cast<std::size_t>(r / end * cells), std::size_t{cells - 1})] +=
            1.0 / count;
    }
    double sum = 0.0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        constexpr int parts = 64;
        double mass = 0.0;
        for (int part = 0; part < parts; ++part) {
            const double r = end * (static_cast<double>(cell) + (part + 0.5) / parts) / cells;
            mass += static_cast<double>(burley_pdf(float(scale), float(r))) * end / cells / parts;
        }
        EXPECT_NEAR(found[cell], mass, 2e-4) << cell;
        sum += mass;
    }
    EXPECT_NEAR(sum, 1.0, 1e-3);
    EXPECT_EQ(burley_pdf(float(scale), float(end) * 1.01f), 0.0f);
}

}  // namespace
}  // namespace eye_render
