#include "render/film.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

PathSample sample_at(int x, int y, float radiance, double weight = 1.0)
{
    PathSample sample;
    sample.x = x;
    sample.y = y;
    sample.weight = weight;
    sample.light.radiance = Color3f(radiance);
    return sample;
}

TEST(Film, averages_by_weight)
{
    Film film({0, 0, 2, 1}, {});
    FilmTile tile = film.take({0, 0, 2, 1});
    tile.add(sample_at(1, 0, 4.0f, 1.0));
    tile.add(sample_at(1, 0, 1.0f, 2.0));
    film.put(tile);
    const std::vector<PassRequest> passes{Pass::Combined};
    const auto images = film.snapshot(passes);
    EXPECT_FLOAT_EQ(images[0].pixels[4], 2.0f);
    EXPECT_FLOAT_EQ(images[0].pixels[7], 1.0f);
    EXPECT_EQ(images[0].pixels[3], 0.0f) << "a pixel without samples is transparent";
}

TEST(Film, exposure_is_a_factor_of_light_and_not_of_coverage)
{
    Film film({0, 0, 1, 1}, {.exposure = 0.25});
    FilmTile tile = film.take({0, 0, 1, 1});
    tile.add(sample_at(0, 0, 4.0f));
    film.put(tile);
    const std::vector<PassRequest> passes{Pass::Combined};
    const auto images = film.snapshot(passes);
    EXPECT_EQ(images[0].pixels[0], 1.0f);
    EXPECT_EQ(images[0].pixels[3], 1.0f);
}

TEST(Film, keeps_earlier_sums_when_a_tile_is_taken_again)
{
    Film film({5, 5, 9, 9}, {});
    for (int round = 0; round < 3; ++round) {
        FilmTile tile = film.take({6, 6, 8, 9});
        tile.add(sample_at(7, 8, static_cast<float>(round)));
        film.put(tile);
    }
    const std::vector<PassRequest> passes{Pass::Combined};
    const std::size_t pixel = 3 * 4 + 2;
    EXPECT_FLOAT_EQ(film.snapshot(passes)[0].pixels[4 * pixel], 1.0f);
}

TEST(Film, counts_what_the_eye_did_with_the_rays_and_leaves_the_lost_ones_out)
{
    Film film({0, 0, 1, 1}, {});
    for (int round = 0; round < 2; ++round) {
        FilmTile tile = film.take({0, 0, 1, 1});
        tile.add(sample_at(0, 0, 3.0f));
        PathSample lost = sample_at(0, 0, 100.0f);
        lost.fate = RayFate::Vignetted;
        tile.add(lost);
        film.put(tile);
    }
    EXPECT_EQ(film.fates()[RayFate::Transmitted], 2U);
    EXPECT_EQ(film.fates()[RayFate::Vignetted], 2U);
    EXPECT_EQ(film.fates()[RayFate::Missed], 0U);
    const std::vector<PassRequest> passes{Pass::Combined};
    EXPECT_EQ(film.snapshot(passes)[0].pixels[0], 3.0f);
}

TEST(Film, darkens_by_the_eye_s_efficiency_and_by_lost_rays_on_request)
{
    Film film({0, 0, 1, 1}, {.efficiency = 0.5});
    FilmTile tile = film.take({0, 0, 1, 1});
    tile.add(sample_at(0, 0, 3.0f));
    PathSample lost = sample_at(0, 0, 0.0f, 2.0);
    lost.fate = RayFate::Missed;
    tile.add(lost);
    film.put(tile);
    const std::vector<PassRequest> passes{Pass::Combined};
    EXPECT_EQ(film.snapshot(passes)[0].pixels, (std::vector<float>{0.5f, 0.5f, 0.5f, 1.0f}));
}

TEST(Film, pictures_of_parts_merge_by_their_sample_weights)
{
    const auto add = [](Film& film, float radiance, const V3d& channel_weight, double weight) {
        FilmTile tile = film.take({0, 0, 1, 1});
        PathSample sample = sample_at(0, 0, radiance, weight);
        sample.channel_weight = channel_weight;
        tile.add(sample);
        film.put(tile);
    };
    const PixelBounds pixel{0, 0, 1, 1};
    Film first(pixel, {.chromatic = true});
    Film second(pixel, {.chromatic = true});
    Film whole(pixel, {.chromatic = true});
    for (Film* film : {&first, &whole}) {
        add(*film, 1.0f, V3d(3.0, 1.0, 0.0), 0.5);
    }
    for (Film* film : {&second, &whole}) {
        add(*film, 8.0f, V3d(0.25, 1.0, 2.0), 2.0);
    }
    const std::vector<PassRequest> passes{Pass::Combined, Pass::SampleWeight};
    const auto a = first.snapshot(passes);
    const auto b = second.snapshot(passes);
    const auto all = whole.snapshot(passes);
    EXPECT_EQ(a[1].pixels, (std::vector<float>{1.5f, 0.5f, 0.0f, 0.5f}));
    EXPECT_EQ(b[1].pixels, (std::vector<float>{0.5f, 2.0f, 4.0f, 2.0f}));
    for (std::size_t channel = 0; channel < 4; ++channel) {
        const float weight = a[1].pixels[channel] + b[1].pixels[channel];
        EXPECT_EQ(weight, all[1].pixels[channel]);
        EXPECT_FLOAT_EQ((a[1].pixels[channel] * a[0].pixels[channel] +
                         b[1].pixels[channel] * b[0].pixels[channel]) /
                            weight,
                        all[0].pixels[channel])
            << "channel " << channel;
    }
}

TEST(Film, shows_chief_samples_as_they_are)
{
    const std::vector<PassRequest> passes{Pass::Depth, Pass::Defocus, Pass::Blur};
    Film film({0, 0, 1, 1}, {.passes = PassLayout(passes)});
    FilmTile tile = film.take({0, 0, 1, 1});
    tile.set(0, 0, std::array{3.0f, -2.0f, 27.5f});
    tile.add(sample_at(0, 0, 1.0f));
    tile.add(sample_at(0, 0, 1.0f));
    film.put(tile);
    const auto images = film.snapshot(passes);
    EXPECT_EQ(images[0].pixels, std::vector<float>{3.0f});
    EXPECT_EQ(images[1].pixels, std::vector<float>{-2.0f});
    EXPECT_EQ(images[2].pixels, std::vector<float>{27.5f});
}

}  // namespace
}  // namespace eye_render
