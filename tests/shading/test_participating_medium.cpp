// Media: what they take, give and scatter.

#include "shading/participating_medium.h"

#include "scattering.h"

#include <gtest/gtest.h>

#include <limits>

namespace eye_render {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

TEST(ParticipatingMedium, takes_exponentially_and_all_of_light_from_infinitely_far)
{
    ParticipatingMedium medium;
    medium.extinction = {0.0f, 0.5f, 2.0f};
    const Color3f left = medium.transmittance(1.5f);
    EXPECT_FLOAT_EQ(left.x, 1.0f);
    EXPECT_FLOAT_EQ(left.y, std::exp(-0.75f));
    EXPECT_FLOAT_EQ(left.z, std::exp(-3.0f));
    EXPECT_EQ(medium.transmittance(infinity), Color3f(1.0f, 0.0f, 0.0f));
}

TEST(ParticipatingMedium, shines_through_what_it_takes)
{
    ParticipatingMedium medium;
    medium.emission = Color3f(3.0f);
    medium.extinction = {0.0f, 1e-30f, 0.5f};
    const Color3f seen = medium.emitted(medium.emission, 2.0f);
    EXPECT_FLOAT_EQ(seen.x, 6.0f);
    EXPECT_FLOAT_EQ(seen.y, 6.0f);
    EXPECT_FLOAT_EQ(seen.z, 3.0f * (1.0f - std::exp(-1.0f)) / 0.5f);
    EXPECT_FLOAT_EQ(medium.emitted(medium.emission, infinity).z, 6.0f);
    medium.emission = Color3f(0.0f);
    EXPECT_EQ(medium.emitted(medium.emission, infinity), Color3f(0.0f));
}

TEST(ParticipatingMedium, overlapping_media_add_up)
{
    ParticipatingMedium haze;
    haze.extinction = Color3f(1.0f);
    haze.scatter({Color3f(0.5f), {.g = 0.2f}});
    ParticipatingMedium both = haze;
    ParticipatingMedium dust;
    dust.extinction = Color3f(2.0f);
    dust.scatter({Color3f(1.0f, 0.0f, 0.0f), {.g = -0.5f}});
    both.add(dust);
    both.add(haze);
    EXPECT_EQ(both.extinction, Color3f(4.0f));
    EXPECT_EQ(both.scattering(), Color3f(2.0f, 1.0f, 1.0f));
    for (const float cosine : {-0.9f, 0.1f, 0.7f}) {
        const Color3f sum = haze.scattered(1.0f - cosine) * 2.0f + dust.scattered(1.0f - cosine);
        EXPECT_NEAR(both.scattered(1.0f - cosine).x, sum.x, 1e-6f);
        EXPECT_NEAR(both.scattered(1.0f - cosine).y, sum.y, 1e-6f);
    }
}

TEST(ParticipatingMedium, many_different_ones_lose_no_light)
{
    ParticipatingMedium sum;
    for (int i = 0; i < 20; ++i) {
        ParticipatingMedium one;
        one.scatter({Color3f(0.5f), {.g = 0.04f * static_cast<float>(i)}});
        sum.add(one);
    }
    EXPECT_EQ(sum.scattering(), Color3f(10.0f));
    double scattered = 0.0;
    test::for_each_direction(256, 1, [&](const V3f& w, double solid_angle) {
        scattered += double(sum.scattered(1.0f - w.z).x) * solid_angle;
    });
    EXPECT_NEAR(scattered, 10.0, 1e-2);
}

TEST(ParticipatingMedium, samples_know_their_value_and_density)
{
    ParticipatingMedium medium;
    medium.scatter({Color3f(0.5f, 0.2f, 0.1f), {.g = 0.8f}});
    medium.scatter({Color3f(0.1f, 0.2f, 0.9f), {.alpha = 1.0f}});
    const V3f along = test::direction_at(30.0);
    double density = 0.0;
    test::for_each_direction(256, 64, [&](const V3f& w, double solid_angle) {
        density += double(medium.pdf(one_minus_cosine(along, w))) * solid_angle;
    });
    EXPECT_NEAR(density, 1.0, 2e-3);
    for (const float u_lobe : {0.1f, 0.9f}) {
        const PhaseSample sample = medium.sample(along, u_lobe, V2f(0.3f, 0.6f));
        EXPECT_EQ(sample.value, medium.scattered(one_minus_cosine(along, sample.direction)));
        EXPECT_EQ(sample.pdf, medium.pdf(one_minus_cosine(along, sample.direction)));
    }
}

}  // namespace
}  // namespace eye_render
