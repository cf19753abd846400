// The world against Cycles, and its sampling against its own density.

#include "scene/environment.h"

#include "../base/chi_squared.h"
#include "../shading/made_up_hit.h"
#include "../shading/options_of.h"
#include "base/units.h"
#include "base/warp.h"
#include "scene/textures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace eye_render {
namespace {

constexpr PathState seen;
constexpr PathState lighting{.is_camera = false, .depth = 1};

// A world, and all that it stands on.
class World {
public:
    World() = default;
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    // `surface` is a Background, or what shines in the place of one.
    void build(const NodeGraph& graph,
               const NodeOutput& surface,
               const std::optional<SunDisc>& sun = std::nullopt)
    {
        test::AnyResources resources;
        material_ = make_material("world", graph, {.surface = surface}, resources);
        frame_.textures = &textures;
        environment = Environment(material_, frame_, sun);
    }
    void build(const Material& material)
    {
        material_ = material;
        frame_.textures = &textures;
        environment = Environment(material_, frame_);
    }
    // Texture 0 around the scene.
    void build_picture(float strength = 1.0f)
    {
        NodeGraph graph;
        const std::size_t picture =
            graph.add("TEX_ENVIRONMENT", test::options_of({{"texture", 0.0}}));
        const std::size_t background = graph.add("BACKGROUND");
        graph.link(background, "Color", graph.output(picture, "Color"));
        graph.set(background, "Strength", V3f(strength));
        build(graph, graph.output(background, "Background"));
    }

    TextureSet textures;
    Environment environment;

private:
    Material material_;
    SceneFrame frame_;
};

// Blender 3.4.1: directions_8x4.exr as the world's Environment Texture, linear interpolation, seen
// by a camera 1e-4 rad wide looking along the direction; 32-bit EXR, mean of the pixels.
struct CyclesFigure {
    V3f direction;
    float red, green;
};

TEST(Environment, directions_map_to_the_picture_as_in_cycles)
{
    World world;
    world.textures.add_file(std::string(EYE_TEST_DATA_DIR) + "/textures/directions_8x4.exr",
                            {.colorspace = Colorspace::Linear});
    world.build_picture();
    for (const CyclesFigure& f :
         std::initializer_list<CyclesFigure>{{{1, 0, .1f}, 1.71862f, 1.22146f},
                                             {{0, 1, .1f}, 1.17663f, 1.22146f},
                                             {{-1, .05f, .1f}, 1.01174f, 1.2214f},
                                             {{-1, -.05f, .1f}, 1.30669f, 1.2214f},
                                             {{0, -1, .1f}, 2.08937f, 1.22146f},
                                             {{1, 1, .5f}, 1.48285f, 1.32948f},
                                             {{-1, 2, -.3f}, 0.90967f, 1.11664f},
                                             {{.3f, -.5f, .8f}, 1.97351f, 1.53419f},
                                             {{.1f, .1f, 5}, 1.48283f, 0.86428f},
                                             {{.1f, .1f, -5}, 1.48287f, 0.74817f}}) {
        const Color3f radiance = world.environment.radiance(f.direction.normalized(), seen);
        EXPECT_NEAR(radiance.x, f.red, 2e-4f) << f.direction;
        EXPECT_NEAR(radiance.y, f.green, 2e-4f) << f.direction;
    }
}

// A dim sky with a sun of one pixel, 10^5 times brighter, and black ground.
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
        world_.textures.add_pixels("sky", PixelsF32{width, height, rgba},
                                   {.colorspace = Colorspace::Linear});
        world_.build_picture(2.0f);
    }

    World world_;
    const Environment& environment_ = world_.environment;
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
            reference += double(
                luminance(environment_.radiance(direction_at(z, (j + 0.5) / grid), lighting)));
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
        EXPECT_EQ(s.radiance, environment_.radiance(s.wi, lighting));
        apart += std::abs(s.pdf - environment_.pdf(s.wi)) > 1e-3f * s.pdf;
    }
    EXPECT_LE(apart, 5);  // rounded across the edge of a cell
}

TEST(Environment, a_constant_world_is_sampled_uniformly_and_has_no_table)
{
    World world;
    world.build(
        plain_material("BACKGROUND", {{"Color", V3f(0.1f, 0.2f, 0.3f)}, {"Strength", V3f(2.0f)}}));
    const Environment& environment = world.environment;
    EXPECT_FALSE(environment.has_table());
    EXPECT_FALSE(environment.is_black());
    EXPECT_EQ(environment.radiance({0, 0, 1}, seen), Color3f(0.2f, 0.4f, 0.6f));
    EXPECT_FLOAT_EQ(environment.mean_luminance(), luminance({0.2f, 0.4f, 0.6f}));
    const EnvironmentSample s = environment.sample({0.3f, 0.8f});
    EXPECT_FLOAT_EQ(s.pdf, uniform_sphere_pdf());
    EXPECT_EQ(s.pdf, environment.pdf(s.wi));
}

// A mix of constants is a constant.
TEST(Environment, an_even_mix_of_backgrounds_has_no_table)
{
    NodeGraph graph;
    const std::size_t mix = graph.add("MIX_SHADER");
    graph.set(mix, "Fac", V3f(0.25f));
    for (const auto& [input, radiance] :
         {std::pair("Shader", 1.0f), std::pair("Shader_001", 3.0f)}) {
        const std::size_t background = graph.add("BACKGROUND");
        graph.set(background, "Color", V3f(radiance));
        graph.link(mix, input, graph.output(background, "Background"));
    }
    World world;
    world.build(graph, graph.output(mix, "Shader"));
    EXPECT_FALSE(world.environment.has_table());
    EXPECT_EQ(world.environment.radiance({0, 0, 1}, seen), Color3f(1.5f));
}

TEST(Environment, black_worlds_are_known_as_such)
{
    EXPECT_TRUE(Environment().is_black());
    const std::vector<float> black = {0, 0, 0, 1, 0, 0, 0, 1};
    World pictured;
    pictured.textures.add_pixels("black", PixelsF32{2, 1, black},
                                 {.colorspace = Colorspace::Linear});
    pictured.build_picture();
    EXPECT_TRUE(pictured.environment.is_black());
    World dimmed;
    dimmed.build(plain_material("BACKGROUND", {{"Strength", V3f(0.0f)}}));
    EXPECT_TRUE(dimmed.environment.is_black());
    EXPECT_FALSE(dimmed.environment.has_table());
    World unlit;
    unlit.build(Material{});
    EXPECT_TRUE(unlit.environment.is_black());
    EXPECT_FALSE(unlit.environment.has_table());
}

TEST(Environment, a_broken_picture_gives_no_nan)
{
    const std::vector<float> broken = {NAN, 1, 1, 1, INFINITY, 1, 1, 1, -5, 1, 1, 1, 1, 1, 1, 1};
    World world;
    world.textures.add_pixels("broken", PixelsF32{4, 1, broken},
                              {.colorspace = Colorspace::Linear});
    world.build_picture();
    for (int i = 0; i < 64; ++i) {
        const EnvironmentSample s = world.environment.sample({(float(i) + 0.5f) / 64.0f, 0.4f});
        EXPECT_TRUE(s.pdf > 0.0f && std::isfinite(s.pdf));
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(s.radiance[c] >= 0.0f && std::isfinite(s.radiance[c]));
        }
    }
}

// The radiance of direction d, as coordinates Generated have it, is d without what is negative.
void build_by_direction(World& world)
{
    NodeGraph graph;
    const std::size_t background = graph.add("BACKGROUND");
    graph.link(background, "Color", graph.output(graph.add("TEX_COORD"), "Generated"));
    world.build(graph, graph.output(background, "Background"));
}

TEST(Environment, a_procedural_world_is_sampled_by_what_it_shows)
{
    World world;
    build_by_direction(world);
    const Environment& environment = world.environment;
    EXPECT_TRUE(environment.has_table());
    EXPECT_EQ(environment.radiance({0.6f, -0.8f, 0.0f}, seen), Color3f(0.6f, 0.0f, 0.0f));
    // The mean of a clamped cosine over the sphere is 1/4; a table of 1024 by 512 cells has it to
    // the square of a cell's width.
    EXPECT_NEAR(environment.mean_luminance(), 0.25f, 1e-4f);
    // Light from above the point: pi of a cosine, in green.
    double irradiance = 0.0;
    constexpr int side = 256;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) {
            const EnvironmentSample s =
                environment.sample({(float(i) + 0.5f) / side, (float(j) + 0.5f) / side});
            EXPECT_NEAR(s.pdf, environment.pdf(s.wi), 0.01f * s.pdf) << s.wi;
            irradiance += double(s.radiance.y * std::max(s.wi.y, 0.0f) / s.pdf);
        }
    }
    // The integral of cos^2 over a hemisphere.
    EXPECT_NEAR(irradiance / (double(side) * side), 2.0 * pi / 3.0, 2e-3);
}

struct Estimate {
    double mean = 0.0;
    double standard_error = 0.0;
};

// Of the irradiance of the ground.
Estimate irradiance(const Environment& environment)
{
    std::mt19937 rng(8);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    constexpr int count = 20000;
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const EnvironmentSample s = environment.sample({uniform(rng), uniform(rng)});
        const double light = double(luminance(s.radiance) * std::max(s.wi.z, 0.0f) / s.pdf);
        sum += light;
        sum_of_squares += light * light;
    }
    const double mean = sum / count;
    return {mean, std::sqrt((sum_of_squares / count - mean * mean) / count)};
}

TEST(Environment, the_sun_of_a_sky_is_aimed_at)
{
    // The table alone, whose cells are a third of a degree, finds the same light with more noise.
    const NodeOptions options({{"sun_elevation", 0.6}, {"sun_rotation", 0.8}});
    NodeGraph graph;
    const std::size_t sky = graph.add("TEX_SKY", options);
    const std::size_t background = graph.add("BACKGROUND");
    graph.link(background, "Color", graph.output(sky, "Color"));
    const NodeOutput surface = graph.output(background, "Background");
    World aimed;
    aimed.build(graph, surface, sun_disc(options, WorkingSpace::Rec709));
    World unaimed;
    unaimed.build(graph, surface);
    const Estimate with = irradiance(aimed.environment);
    const Estimate without = irradiance(unaimed.environment);
    EXPECT_NEAR(with.mean, without.mean, 4.0 * without.standard_error);
    EXPECT_LT(with.standard_error, 0.7 * without.standard_error);
    const V3f to_sun = sun_disc(options, WorkingSpace::Rec709)->direction;
    EXPECT_GT(aimed.environment.pdf(to_sun), 0.5f * unaimed.environment.pdf(to_sun));
}

// A world that is bright for the eye alone lights nothing: the table follows what lights.
TEST(Environment, a_world_may_look_at_the_path)
{
    NodeGraph graph;
    const std::size_t background = graph.add("BACKGROUND");
    graph.link(background, "Color", graph.output(graph.add("LIGHT_PATH"), "Is Camera Ray"));
    World world;
    world.build(graph, graph.output(background, "Background"));
    EXPECT_EQ(world.environment.radiance({0, 0, 1}, seen), Color3f(1.0f));
    EXPECT_EQ(world.environment.radiance({0, 0, 1}, lighting), Color3f(0.0f));
    EXPECT_EQ(world.environment.sample({0.5f, 0.5f}).radiance, Color3f(0.0f));
    EXPECT_TRUE(world.environment.is_black());
}

TEST(Environment, a_colour_in_the_place_of_a_background_shines)
{
    NodeGraph graph;
    World world;
    const std::size_t coordinates = graph.add("TEX_COORD");
    world.build(graph, graph.output(coordinates, "Generated"));
    EXPECT_EQ(world.environment.radiance({0.0f, 0.6f, 0.8f}, seen), Color3f(0.0f, 0.6f, 0.8f));
}

}  // namespace
}  // namespace eye_render
