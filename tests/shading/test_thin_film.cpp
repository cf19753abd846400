// A film between media against the two boundaries it lies between, and against the textbook's
// quarter and half waves.

#include "shading/fresnel.h"
#include "shading/thin_film.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(ThinFilm, a_film_of_the_base_itself_is_not_there)
{
    for (float cosine : {1.0f, 0.7f, 0.2f}) {
        const Color3f found = film_reflectance(cosine, 400.0f, 1.5f, 1.5f, WorkingSpace::Rec709);
        const float expected = fresnel_dielectric(cosine, 1.5f).reflectance;
        for (int c = 0; c < 3; ++c) {
            EXPECT_NEAR(found[c], expected, 2e-3f) << cosine;
        }
    }
}

TEST(ThinFilm, a_film_without_thickness_is_not_there)
{
    for (float cosine : {1.0f, 0.7f, 0.2f}) {
        EXPECT_NEAR(film_reflectance(cosine, 1e-3f, 1.8f, 1.5f, WorkingSpace::Rec709).y,
                    fresnel_dielectric(cosine, 1.5f).reflectance, 2e-3f)
            << cosine;
    }
}

TEST(ThinFilm, a_thick_film_reflects_as_two_boundaries_without_interference)
{
    // R = R1 + T1^2 R2 / (1 - R1 R2), as intensities add up once no wave remembers another.
    const float r1 = f0_from_ior(1.33f);
    const float r2 = f0_from_ior(1.5f / 1.33f);
    const float expected = r1 + (1.0f - r1) * (1.0f - r1) * r2 / (1.0f - r1 * r2);
    const Color3f found = film_reflectance(1.0f, 20000.0f, 1.33f, 1.5f, WorkingSpace::Rec709);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], expected, 1e-4f);
    }
}

TEST(ThinFilm, a_quarter_wave_dims_and_a_half_wave_leaves_green)
{
    // Magnesium fluoride, index 1.38, on glass: at 550 nm a film of a quarter wave reflects
    // ((n^2 - 1.5) / (n^2 + 1.5))^2 = 1.4 %, one of a half wave the 4 % of bare glass. Y averages
    // over the eye's curve, so the quarter's minimum is filled and the half's maximum rounded.
    constexpr float quarter_nm = 550.0f / 4.0f / 1.38f;
    const float quarter = film_reflectance(1.0f, quarter_nm, 1.38f, 1.5f, WorkingSpace::Rec709).y;
    const float half =
        film_reflectance(1.0f, 2.0f * quarter_nm, 1.38f, 1.5f, WorkingSpace::Rec709).y;
    EXPECT_NEAR(quarter, 0.014f, 2e-3f);
    EXPECT_NEAR(half, 0.04f, 4e-3f);
}

TEST(ThinFilm, all_is_reflected_beyond_the_critical_angle)
{
    EXPECT_EQ(film_reflectance(0.3f, 300.0f, 0.8f, 1.0f / 1.5f, WorkingSpace::Rec709),
              Color3f(1.0f));
    EXPECT_EQ(tinted_film_reflectance(0.3f, 300.0f, 0.8f, 1.0f / 1.5f, Color3f(0.01f),
                                      WorkingSpace::Rec709),
              Color3f(1.0f));
}

TEST(ThinFilm, a_tint_scales_what_is_reflected_from_above)
{
    // Where as much is reflected as without a film, all of the tint is seen.
    const Color3f f0(0.01f, 0.04f, 0.08f);
    const Color3f found =
        tinted_film_reflectance(1.0f, 400.0f, 1.5f, 1.5f, f0, WorkingSpace::Rec709);
    for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(found[c], f0[c], 2e-3f);
    }
}

TEST(ThinFilm, is_one_colour_in_all_spaces)
{
    // A faint one: neither space cuts any of it off.
    constexpr float rounding = 1e-5f;
    const Color3f found = film_reflectance(0.9f, 1500.0f, 1.33f, 1.5f, WorkingSpace::Rec709);
    EXPECT_GT(std::min({found.x, found.y, found.z}), 0.0f);
    for (const WorkingSpace space : {WorkingSpace::Rec2020, WorkingSpace::AcesCg}) {
        EXPECT_LE(
            (film_reflectance(0.9f, 1500.0f, 1.33f, 1.5f, space) - rgb_from_rec709(found, space))
                .length(),
            rounding);
    }
    EXPECT_GT(std::abs(found.x - found.y), 10.0f * rounding) << "grey is the same in all";
}

}  // namespace
}  // namespace eye_render
