// The world against Cycles, and its sampling against its own density.

#include "scene/environment.h"

#include "../base/chi_squared.h"
#include "base/units.h"
#include "base/warp.h"
#include "scene/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

// Blender 3.4.1: directions_8x4.exr as the world's Environment Texture, linear interpolation, seen
// by a camera 1e-4 rad wide looking along the direction; 32-bit EXR, mean of the pixels.
struct CyclesFigure {
    V3f direction;
    float red, green;
};

void expect_figures(const Environment& environment, std::initializer_list<CyclesFigure> figures)
{
    for (const CyclesFigure& f : figures) {
        const Color3f radiance = environment.radiance(f.direction.normalized());
        EXPECT_NEAR(radiance.x, f.red, 2e-4f) << f.direction;
        EXPECT_NEAR(radiance.y, f.green, 2e-4f) << f.direction;
    }
}

int add_directions(TextureSet& set)
{
    return set.add_file(std::string(EYE_TEST_DATA_DIR) + "/textures/directions_8x4.exr",
                        {.colorspace = Colorspace::Linear});
}

TEST(Environment, directions_map_to_the_picture_as_in_cycles)
{
    TextureSet set;
    const Environment environment({.texture = add_directions(set)}, &set);
    expect_figures(environment, {{{1, 0, .1f}, 1.71862f, 1.22146f},
                                 {{0, 1, .1f}, 1.17663f, 1.22146f},
                                 {{-1, .05f, .1f}, 1.01174f, 1.2214f},
                                 {{-1, -.05f, .1f}, 1.30669f, 1.2214f},
                                 {{0, -1, .1f}, 2.08937f, 1.22146f},
                                 {{1, 1, .5f}, 1.48285f, 1.32948f},
                                 {{-1, 2, -.3f}, 0.90967f, 1.11664f},
                                 {{.3f, -.5f, .8f}, 1.97351f, 1.53419f},
                                 {{.1f, .1f, 5}, 1.48283f, 0.86428f},
                                 {{.1f, .1f, -5}, 1.48287f, 0.74817f}});
}

// With a Mapping node (Point) whose rotation is (0.2, 0.3, 1.0) rad: its matrix takes the
// direction to the picture.
TEST(Environment, rotation_turns_the_picture_as_in_cycles)
{
    const M33f mapping(0.516170f, -0.793041f, 0.323437f,  //
                       0.803885f, 0.578901f, 0.136505f,   //
                       -0.295520f, 0.189796f, 0.936293f);
    TextureSet set;
    const Environment environment(
        {.texture = add_directions(set), .texture_from_world = mapping.transposed()}, &set);
    expect_figures(environment, {{{1, 0, .1f}, 1.41869f, 1.08565f},
                                 {{0, 1, .1f}, 0.3427f, 1.30522f},
                                 {{1, 1, .5f}, 1.14106f, 1.28639f},
                                 {{-1, 2, -.3f}, 0.7418f, 1.25563f}});
}

// A dim sky with a sun of one pixel, 10^5 times brighter, and black ground; turned askew.
class Sky : public testing::Test {
protected:
    static constexpr int width = 64;
    static constexpr int height = 32;

    Sky()
    {
        std::vector<float> rgba;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const bool sun = x == 20 && y == 25;
                const float value = y < 12 ? 0.0f : 0.5f + 0.01f * float(x);
                rgba.insert(rgba.end(), {sun ? 1e5f : value, value, value, 1.0f});
            }
        }
        const M33f turned =
            M33f().setRotation(0.7f) * M33f(1, 0, 0, 0, 0.8f, 0.6f, 0, -0.6f, 0.8f);
        const int texture = set_.add_pixels("sky", PixelsF32{width, height, rgba},
                                            {.colorspace = Colorspace::Linear});
        environment_ = Environment(
            {.strength = 2.0f, .texture = texture, .texture_from_world = turned}, &set_);
    }

    TextureSet set_;
    Environment environment_;
};

V3f direction_at(double z, double turn)
{
    const double across = std::sqrt(std::max(0.0, 1.0 - z * z));
    return {float(across * std::cos(2.0 * pi * turn)), float(across * std::sin(2.0 * pi * turn)),
            float(z)};
}

TEST_F(Sky, density_integrates_to_one)
{
    constexpr int grid = 1500;
    double sum = 0.0;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const double z = 2.0 * (i + 0.5) / grid - 1.0;
            sum += double(environment_.pdf(direction_at(z, (j + 0.5) / grid)));
        }
    }
    // 4 pi over the number of points; the sun's pixel covers 450 of them, with an edge of 80.
    EXPECT_NEAR(sum * 4.0 * pi / (double(grid) * grid), 1.0, 0.02);
}

TEST_F(Sky, samples_follow_the_density)
{
    constexpr int rows = 24;
    constexpr int columns = 48;
    constexpr int fine = 24;  // of each cell, to integrate the density
    constexpr int count = 1000000;
    std::vector<double> observed(rows * columns);
    std::vector<double> expected(rows * columns);
    std::mt19937 rng(5);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    int near_sun = 0;
    for (int i = 0; i < count; ++i) {
        const EnvironmentSample s = environment_.sample({uniform(rng), uniform(rng)});
        ASSERT_NEAR(s.wi.length(), 1.0f, 1e-4f);
        // The steep sun would need a finer integral than the rest: count it apart.
        if (s.pdf > 1.0f) {
            ++near_sun;
            continue;
        }
        const double turn = std::atan2(double(s.wi.y), double(s.wi.x)) / (2.0 * pi);
        const int row = std::clamp(int((double(s.wi.z) + 1.0) * 0.5 * rows), 0, rows - 1);
        const int column = std::clamp(int((turn < 0 ? turn + 1 : turn) * columns), 0, columns - 1);
        ++observed[std::size_t(row * columns + column)];
    }
    double expected_away = 0.0;
    for (int i = 0; i < rows * fine; ++i) {
        for (int j = 0; j < columns * fine; ++j) {
            const double z = 2.0 * (i + 0.5) / (rows * fine) - 1.0;
            const double pdf =
                double(environment_.pdf(direction_at(z, (j + 0.5) / (columns * fine))));
            const double cell = count * 4.0 * pi / (double(rows) * columns * fine * fine);
            if (pdf <= 1.0) {
                expected[std::size_t(i / fine * columns + j / fine)] += pdf * cell;
                expected_away += pdf * cell;
            }
        }
    }
    EXPECT_NEAR(near_sun, count - expected_away, 0.002 * count);
    const test::ChiSquared chi = test::chi_squared_test(observed, expected, 0.01);
    EXPECT_LT(chi.statistic, chi.critical);
}

TEST_F(Sky, light_found_by_sampling_is_the_light_there_is)
{
    constexpr int grid = 1500;
    double reference = 0.0;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const double z = 2.0 * (i + 0.5) / grid - 1.0;
            reference +=
                double(luminance(environment_.radiance(direction_at(z, (j + 0.5) / grid))));
        }
    }
    reference *= 4.0 * pi / (double(grid) * grid);
    constexpr int side = 300;
    double sampled = 0.0;
    float worst = 0.0f;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const EnvironmentSample s =
                environment_.sample({(float(i) + 0.5f) / side, (float(j) + 0.5f) / side});
            const float weight = luminance(s.radiance) / s.pdf;
            sampled += double(weight);
            worst = std::max(worst, weight);
        }
    }
    EXPECT_NEAR(sampled / (double(side) * side), reference, 0.01 * reference);
    EXPECT_NEAR(double(environment_.mean_luminance()) * 4.0 * pi, reference, 0.01 * reference);
    // The sun is 10^5 times the sky, yet no sample weighs more than 16 times the mean. That is the
    // worst there is: in the corner of the cell diagonally next to the sun's, where the bilinear
    // picture has 1/4 of the sun's radiance and the cell's mean is 1/64 of it.
    EXPECT_LT(double(worst), 17.0 * reference);
}

TEST_F(Sky, density_of_a_sample_is_that_of_its_direction)
{
    std::mt19937 rng(6);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    int apart = 0;
    for (int i = 0; i < 20000; ++i) {
        const EnvironmentSample s = environment_.sample({uniform(rng), uniform(rng)});
        EXPECT_EQ(s.radiance, environment_.radiance(s.wi));
        apart += std::abs(s.pdf - environment_.pdf(s.wi)) > 1e-3f * s.pdf;
    }
    EXPECT_LE(apart, 5);  // rounded across the edge of a cell
}

TEST(Environment, a_constant_world_is_sampled_uniformly_and_has_no_table)
{
    const Environment environment({.color = {0.1f, 0.2f, 0.3f}, .strength = 2.0f}, nullptr);
    EXPECT_FALSE(environment.has_table());
    EXPECT_FALSE(environment.is_black());
    EXPECT_EQ(environment.radiance({0, 0, 1}), Color3f(0.2f, 0.4f, 0.6f));
    EXPECT_FLOAT_EQ(environment.mean_luminance(), luminance({0.2f, 0.4f, 0.6f}));
    const EnvironmentSample s = environment.sample({0.3f, 0.8f});
    EXPECT_FLOAT_EQ(s.pdf, uniform_sphere_pdf());
    EXPECT_EQ(s.pdf, environment.pdf(s.wi));
}

TEST(Environment, black_worlds_are_known_as_such)
{
    TextureSet set;
    const std::vector<float> black = {0, 0, 0, 1, 0, 0, 0, 1};
    const int texture =
        set.add_pixels("black", PixelsF32{2, 1, black}, {.colorspace = Colorspace::Linear});
    EXPECT_TRUE(Environment().is_black());
    EXPECT_TRUE(Environment({.texture = texture}, &set).is_black());
    EXPECT_TRUE(Environment({.color = Color3f(1.0f), .strength = 0.0f}, nullptr).is_black());
}

TEST(Environment, a_broken_picture_gives_no_nan)
{
    TextureSet set;
    const std::vector<float> broken = {NAN, 1, 1, 1, INFINITY, 1, 1, 1, -5, 1, 1, 1, 1, 1, 1, 1};
    const int texture =
        set.add_pixels("broken", PixelsF32{4, 1, broken}, {.colorspace = Colorspace::Linear});
    const Environment environment({.texture = texture}, &set);
    for (int i = 0; i < 64; ++i) {
        const EnvironmentSample s = environment.sample({(float(i) + 0.5f) / 64.0f, 0.4f});
        EXPECT_TRUE(s.pdf > 0.0f && std::isfinite(s.pdf));
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(s.radiance[c] >= 0.0f && std::isfinite(s.radiance[c]));
        }
    }
}

TEST(Environment, refuses_negative_light_and_matrices_that_stretch)
{
    EXPECT_THROW(Environment({.strength = -1.0f}, nullptr), std::invalid_argument);
    EXPECT_THROW(Environment({.color = Color3f(NAN)}, nullptr), std::invalid_argument);
    EXPECT_THROW(Environment({.texture_from_world = M33f() * 2.0f}, nullptr),
                 std::invalid_argument);
}

}  // namespace
}  // namespace eye_render
