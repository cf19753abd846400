// Lamps against Cycles, against closed forms, and against their own densities.

#include "scene/lamp.h"

#include "../base/chi_squared.h"
#include "base/units.h"
#include "base/warp.h"
#include "lamp_figures.h"
#include "shading/frame.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace eye_render {
namespace {

// A lamp at `position` that shines straight down unless `z_axis` says otherwise.
LampSettings at(LampSettings settings, const V3f& position, const V3f& z_axis = {0, 0, 1})
{
    const Frame frame(z_axis);
    M44f& m = settings.world_from_light;
    for (int i = 0; i < 3; ++i) {
        m[0][i] = frame.s[i];
        m[1][i] = frame.t[i];
        m[2][i] = frame.n[i];
        m[3][i] = position[i];
    }
    return settings;
}

// Irradiance at p of a plane with normal n, by sampling the lamp at the centres of a grid.
double irradiance(const Lamp& lamp, const V3f& p, const V3f& n, int grid = 256)
{
    double sum = 0.0;
    for (int i = 0; i < grid; ++i) {
        for (int j = 0; j < grid; ++j) {
            const V2f u((float(i) + 0.5f) / float(grid), (float(j) + 0.5f) / float(grid));
            if (const auto s = sample_lamp(lamp, p, u)) {
                sum += double(luminance(s->radiance) * std::max(0.0f, s->wi.dot(n)) / s->pdf);
            }
        }
    }
    return sum / (double(grid) * grid);
}

const V3f origin(0.0f);
const V3f up(0.0f, 0.0f, 1.0f);

TEST(Lamp, gives_the_irradiance_of_cycles)
{
    for (const CyclesFigure& figure : cycles_figures()) {
        const Lamp lamp = make_lamp(at(figure.settings, {figure.x, 0.0f, 2.0f}));
        EXPECT_NEAR(irradiance(lamp, origin, up), figure.irradiance, 0.005 * figure.irradiance)
            << figure.name;
    }
}

TEST(Lamp, scale_stretches_an_area_lamp_as_in_cycles)
{
    LampSettings settings =
        at({.kind = LampKind::Area, .color = Color3f(100.0f), .size_x = 0.5f, .size_y = 0.25f},
           {0.0f, 0.0f, 2.0f});
    settings.world_from_light[0][0] *= 2.0f;
    settings.world_from_light[0][1] *= 2.0f;
    settings.world_from_light[0][2] *= 2.0f;
    EXPECT_NEAR(irradiance(make_lamp(settings), origin, up), 7.624278, 0.005 * 7.624278);
}

// Lamps with an extent, near and far, seen by the origin.
struct Extended {
    std::string name;
    Lamp lamp;
};

std::vector<Extended> extended_lamps()
{
    const LampSettings area{.kind = LampKind::Area,
                            .color = Color3f(10.0f, 5.0f, 2.0f),
                            .size_x = 2.0f,
                            .size_y = 1.0f};
    LampSettings disk = area;
    disk.shape = LampShape::Disk;
    LampSettings sphere{.color = Color3f(10.0f), .radius = 0.5f, .soft_falloff = false};
    LampSettings facing = sphere;
    facing.soft_falloff = true;
    LampSettings sun{.kind = LampKind::Sun, .color = Color3f(3.0f), .angle_rad = rad(0.526)};
    const V3f tilted = V3f(0.4f, -0.3f, 0.8f).normalized();
    return {
        {"rectangle near", make_lamp(at(area, {0.3f, -0.2f, 0.7f}, tilted))},
        {"rectangle far", make_lamp(at(area, {30.0f, -20.0f, 70.0f}, tilted))},
        {"rectangle beside", make_lamp(at(area, {3.0f, 0.5f, 0.4f}))},
        {"disk near", make_lamp(at(disk, {0.3f, -0.2f, 0.7f}, tilted))},
        {"disk far", make_lamp(at(disk, {30.0f, -20.0f, 70.0f}, tilted))},
        {"sphere near", make_lamp(at(sphere, {0.3f, -0.2f, 0.7f}))},
        {"sphere far", make_lamp(at(sphere, {30.0f, -20.0f, 70.0f}))},
        {"sphere around", make_lamp(at(sphere, {0.1f, 0.2f, 0.3f}))},
        {"facing disk near", make_lamp(at(facing, {0.3f, -0.2f, 0.7f}))},
        {"facing disk far", make_lamp(at(facing, {30.0f, -20.0f, 70.0f}))},
        {"the sun", make_lamp(at(sun, origin, tilted))},
    };
}

TEST(Lamp, a_ray_along_a_sample_meets_the_lamp_there)
{
    std::mt19937 rng(1);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    for (const Extended& e : extended_lamps()) {
        int missed = 0;
        for (int i = 0; i < 10000; ++i) {
            const V2f u(uniform(rng), uniform(rng));
            const auto sample = sample_lamp(e.lamp, origin, u);
            ASSERT_TRUE(sample) << e.name << ", u " << u;
            ASSERT_NEAR(sample->wi.length(), 1.0f, 1e-5f) << e.name;
            const auto hit =
                lamp_hit(e.lamp, origin, sample->wi, std::numeric_limits<float>::infinity());
            if (!hit) {
                ++missed;
                continue;
            }
            // Near a sphere's rim the distance is a root of nearly nothing.
            if (std::isfinite(sample->distance)) {
                EXPECT_NEAR(hit->t, sample->distance, 5e-3f * sample->distance) << e.name;
            }
            EXPECT_NEAR(hit->pdf, sample->pdf, 1e-3f * sample->pdf) << e.name << ", u " << u;
            EXPECT_EQ(hit->radiance, sample->radiance) << e.name;
        }
        // Only a sample on the very edge may round to the outside.
        EXPECT_LE(missed, 5) << e.name;
    }
}

TEST(Lamp, densities_integrate_to_one)
{
    for (const Extended& e : extended_lamps()) {
        // A cone around the lamp, or the whole sphere when it is near.
        const V3f to_lamp = e.lamp.kind == LampKind::Sun ? e.lamp.axis_z : e.lamp.position;
        const bool is_far = e.lamp.kind == LampKind::Sun || to_lamp.length() > 10.0f;
        const float one_minus_cos = !is_far ? 2.0f : e.lamp.kind == LampKind::Sun ? 2e-5f : 4e-4f;
        const Frame frame(to_lamp.normalized());
        constexpr int grid = 1500;
        double sum = 0.0;
        for (int i = 0; i < grid; ++i) {
            for (int j = 0; j < grid; ++j) {
                const V2f u((float(i) + 0.5f) / grid, (float(j) + 0.5f) / grid);
                const V3f wi = frame.world_from_local(sample_uniform_cone(u, one_minus_cos));
                const auto hit =
                    lamp_hit(e.lamp, origin, wi, std::numeric_limits<float>::infinity());
                sum += hit ? double(hit->pdf) : 0.0;
            }
        }
        const double integral =
            sum / (double(grid) * grid) / double(uniform_cone_pdf(one_minus_cos));
        // The edge crosses some 1/1500 of the cells of the grid each way.
        EXPECT_NEAR(integral, 1.0, 5e-3) << e.name;
    }
}

TEST(Lamp, samples_of_a_near_rectangle_follow_its_solid_angle)
{
    const Lamp lamp = extended_lamps()[0].lamp;
    constexpr int cells = 16;
    constexpr int count = 1000000;
    std::vector<double> observed(cells * cells);
    std::vector<double> expected(cells * cells);
    std::mt19937 rng(2);
    std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
    const auto index_of = [&](const V3f& p) {
        const V3f d = p - lamp.position;
        const auto cell = [](float x, float half) {
            return std::clamp(int((x / half + 1.0f) * 0.5f * cells), 0, cells - 1);
        };
        return std::size_t(cell(d.dot(lamp.axis_x), lamp.half_x) * cells +
                           cell(d.dot(lamp.axis_y), lamp.half_y));
    };
    for (int i = 0; i < count; ++i) {
        const auto s = sample_lamp(lamp, origin, {uniform(rng), uniform(rng)});
        ++observed[index_of(s->wi * s->distance)];
    }
    constexpr int fine = 64 * cells;
    for (int i = 0; i < fine; ++i) {
        for (int j = 0; j < fine; ++j) {
            const float x = ((float(i) + 0.5f) / fine * 2.0f - 1.0f) * lamp.half_x;
            const float y = ((float(j) + 0.5f) / fine * 2.0f - 1.0f) * lamp.half_y;
            const V3f p = lamp.position + lamp.axis_x * x + lamp.axis_y * y;
            const V3f wi = p.normalized();
            const auto hit = lamp_hit(lamp, origin, wi, 1e6f);
            const double area = double(area_lamp_area(lamp)) / (double(fine) * fine);
            expected[index_of(p)] +=
                count * double(hit->pdf * wi.dot(lamp.axis_z)) * area / double(p.length2());
        }
    }
    const test::ChiSquared chi = test::chi_squared_test(observed, expected, 0.01);
    EXPECT_LT(chi.statistic, chi.critical);
}

TEST(Lamp, sampling_the_lamp_and_sampling_the_cosine_agree)
{
    for (const Extended& e : extended_lamps()) {
        if (e.lamp.kind == LampKind::Sun || e.lamp.position.length() > 10.0f) {
            continue;  // too small a target for the cosine
        }
        constexpr int grid = 1500;
        double sum = 0.0;
        std::mt19937 rng(3);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        for (int i = 0; i < grid; ++i) {
            for (int j = 0; j < grid; ++j) {
                // Jittered: the horizon is a line of the grid.
                const V3f wi = sample_cosine_hemisphere(
                    {(float(i) + uniform(rng)) / grid, (float(j) + uniform(rng)) / grid});
                const auto hit = lamp_hit(e.lamp, origin, wi, 1e6f);
                sum += hit ? double(luminance(hit->radiance)) * pi : 0.0;
            }
        }
        const double expected = irradiance(e.lamp, origin, up);
        EXPECT_NEAR(sum / (double(grid) * grid), expected, 5e-3 * expected) << e.name;
    }
}

TEST(Lamp, sphere_gives_the_irradiance_of_a_point_at_any_distance)
{
    for (const float radius : {0.01f, 0.5f, 1.9f}) {
        const Lamp lamp = make_lamp(
            at({.color = Color3f(100.0f), .radius = radius, .soft_falloff = false}, {0, 0, 2}));
        EXPECT_NEAR(irradiance(lamp, origin, up), 100.0 / (16.0 * pi), 0.002) << radius;
    }
}

// Lambert's formula: pi E / L is the sum over the edges of the angle that the edge subtends times
// the cosine between the normal and the plane through edge and point, halved.
TEST(Lamp, rectangle_gives_lamberts_irradiance)
{
    for (const Extended& e : extended_lamps()) {
        if (e.name != "rectangle near" && e.name != "rectangle far") {
            continue;
        }
        const V3f x = e.lamp.axis_x * e.lamp.half_x;
        const V3f y = e.lamp.axis_y * e.lamp.half_y;
        const V3f c = e.lamp.position;
        const V3d corners[4] = {V3d(c - x - y), V3d(c + x - y), V3d(c + x + y), V3d(c - x + y)};
        // All of the rectangle must be above the plane.
        const V3d normal = V3d(c).normalized();
        double form = 0.0;
        for (int i = 0; i < 4; ++i) {
            const V3d a = corners[i].normalized();
            const V3d b = corners[(i + 1) % 4].normalized();
            form += std::acos(a.dot(b)) * a.cross(b).normalized().dot(normal);
        }
        const double expected = 0.5 * std::abs(form) * double(luminance(e.lamp.emission));
        EXPECT_NEAR(irradiance(e.lamp, origin, V3f(normal)), expected, 1e-3 * expected) << e.name;
    }
}

TEST(Lamp, sun_gives_its_strength_to_a_plane_square_to_it)
{
    for (const double angle_deg : {0.0, 0.001, 0.526, 20.0, 150.0}) {
        const Lamp lamp = make_lamp(
            {.kind = LampKind::Sun, .color = Color3f(3.0f), .angle_rad = rad(angle_deg)});
        EXPECT_NEAR(irradiance(lamp, origin, up), 3.0, 0.003) << angle_deg;
    }
}

TEST(Lamp, spot_after_blender_3_4_is_not_dimmed_by_the_cosine_and_follows_the_scale)
{
    LampSettings settings = at({.kind = LampKind::Spot,
                                .color = Color3f(100.0f),
                                .spot_angle_rad = rad(50),
                                .spot_blend = 0.3f},
                               {2.0f * std::tan(rad(20)), 0.0f, 2.0f});
    const double point = 100.0 / (16.0 * pi) * std::pow(std::cos(rad_from_deg(20)), 3);
    EXPECT_NEAR(irradiance(make_lamp(settings), origin, up), point, 1e-3 * point);
    // Stretched along the direction that the point lies in, the cone reaches tan 25 * 2.
    settings.world_from_light[3][0] = 2.0f * std::tan(rad(40));
    EXPECT_EQ(irradiance(make_lamp(settings), origin, up), 0.0);
    for (int i = 0; i < 3; ++i) {
        settings.world_from_light[0][i] *= 2.0f;
    }
    EXPECT_GT(irradiance(make_lamp(settings), origin, up), 0.1);
}

TEST(Lamp, shines_to_one_side_only)
{
    const Lamp area =
        make_lamp(at({.kind = LampKind::Area, .color = Color3f(1.0f)}, {0, 0, 1}, {0, 0, -1}));
    EXPECT_FALSE(sample_lamp(area, origin, {0.5f, 0.5f}));
    EXPECT_FALSE(lamp_hit(area, origin, up, 10.0f));
    const Lamp spot = make_lamp(at(
        {.kind = LampKind::Spot, .color = Color3f(1.0f), .spot_angle_rad = rad(170)}, {0, 0, -1}));
    EXPECT_FALSE(sample_lamp(spot, origin, {0.5f, 0.5f}));
}

TEST(Lamp, delta_lamps_are_flagged_and_never_met_by_rays)
{
    const Lamp point = make_lamp(at({.color = Color3f(1.0f)}, {0, 0, 1}));
    const auto sample = sample_lamp(point, origin, {0.5f, 0.5f});
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->is_delta);
    EXPECT_EQ(sample->pdf, 1.0f);
    EXPECT_FALSE(lamp_hit(point, origin, up, 10.0f));
    const Lamp sun = make_lamp({.kind = LampKind::Sun, .color = Color3f(1.0f)});
    EXPECT_FALSE(lamp_hit(sun, origin, up, std::numeric_limits<float>::infinity()));
    EXPECT_FALSE(sample_lamp(point, {0, 0, 1}, {0.5f, 0.5f}));  // at the lamp itself
}

TEST(Lamp, is_not_met_beyond_the_end_of_the_ray)
{
    const Lamp lamp = make_lamp(at({.kind = LampKind::Area, .color = Color3f(1.0f)}, {0, 0, 1}));
    EXPECT_TRUE(lamp_hit(lamp, origin, up, 1.01f));
    EXPECT_FALSE(lamp_hit(lamp, origin, up, 0.99f));
}

TEST(Lamp, peak_intensity_bounds_the_irradiance_of_a_far_point)
{
    for (const Extended& e : extended_lamps()) {
        const bool sun = e.lamp.kind == LampKind::Sun;
        const V3f p = sun ? origin : e.lamp.position - e.lamp.axis_z * 100.0f;
        const V3f n = e.lamp.axis_z;
        const double bound = double(lamp_peak_intensity(e.lamp)) / (sun ? 1.0 : 1e4);
        EXPECT_NEAR(irradiance(e.lamp, p, n), bound, 2e-3 * bound) << e.name;
    }
}

TEST(Lamp, refuses_what_is_no_lamp)
{
    EXPECT_THROW((void)make_lamp({.radius = -1.0f}), std::invalid_argument);
    EXPECT_THROW((void)make_lamp({.color = Color3f(NAN)}), std::invalid_argument);
    EXPECT_THROW((void)make_lamp({.spot_blend = 1.5f}), std::invalid_argument);
    EXPECT_THROW((void)make_lamp({.spread_rad = 4.0f}), std::invalid_argument);
    // Squashed flat it is still a lamp.
    const Lamp flat = make_lamp(
        at({.kind = LampKind::Area, .color = Color3f(100.0f), .size_x = 0.0f, .size_y = 0.1f},
           {0, 0, 2}));
    EXPECT_NEAR(irradiance(flat, origin, up), 7.9577, 0.01);  // P / (pi d^2)
}

}  // namespace
}  // namespace eye_render
