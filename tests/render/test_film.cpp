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
    const Pass passes[] = {Pass::Combined};
    const auto images = film.snapshot(passes);
    EXPECT_FLOAT_EQ(images[0].pixels[4], 2.0f);
    EXPECT_FLOAT_EQ(images[0].pixels[7], 1.0f);
    EXPECT_EQ(images[0].pixels[3], 0.0f) << "a pixel without samples is transparent";
}

TEST(Film, keeps_earlier_sums_when_a_tile_is_taken_again)
{
    Film film({5, 5, 9, 9}, {});
    for (int round = 0; round < 3; ++round) {
        FilmTile tile = film.take({6, 6, 8, 9});
        tile.add(sample_at(7, 8, static_cast<float>(round)));
        film.put(tile);
    }
    const Pass passes[] = {Pass::Combined};
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
    const Pass passes[] = {Pass::Combined};
    EXPECT_EQ(film.snapshot(passes)[0].pixels[0], 3.0f);
}

TEST(Film, shows_chief_samples_as_they_are)
{
    Film film({0, 0, 1, 1}, {.chief = true});
    FilmTile tile = film.take({0, 0, 1, 1});
    tile.set(0, 0, {.depth = 3.0f, .defocus_d = -2.0f, .blur_arcmin = 27.5f});
    tile.add(sample_at(0, 0, 1.0f));
    tile.add(sample_at(0, 0, 1.0f));
    film.put(tile);
    const Pass passes[] = {Pass::Depth, Pass::Defocus, Pass::Blur};
    const auto images = film.snapshot(passes);
    EXPECT_EQ(images[0].pixels, std::vector<float>{3.0f});
    EXPECT_EQ(images[1].pixels, std::vector<float>{-2.0f});
    EXPECT_EQ(images[2].pixels, std::vector<float>{27.5f});
}

}  // namespace
}  // namespace eye_render
