// Each warp against its own density (chi-squared) and its own inverse.

#include "base/units.h"
#include "base/warp.h"
#include "chi_squared.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <string>

namespace eye_render {
namespace {

// A shape seen through coordinates (s, t) in [0, 1]^2 of its own, which the warp knows nothing of.
struct Shape {
    std::string name;
    std::function<V2d(const V2f& u)> sample_st;
    std::function<double(double s, double t)> density_st;  // pdf times the area of ds dt
};

double turn_of(double x, double y)
{
    const double turn = std::atan2(y, x) / (2.0 * pi);
    return turn < 0.0 ? turn + 1.0 : turn;
}

Shape cone_shape(const std::string& name, float one_minus_cos, auto sample, auto pdf)
{
    return {name,
            [=](const V2f& u) {
                const V3f w = sample(u);
                return V2d((1.0 - double(w.z)) / one_minus_cos, turn_of(w.x, w.y));
            },
            [=](double s, double) {
                return pdf(float(1.0 - s * one_minus_cos)) * one_minus_cos * 2.0 * pi;
            }};
}

std::vector<Shape> shapes()
{
    const auto uniform_cone = [](float one_minus_cos) {
        return cone_shape(
            "cone " + std::to_string(one_minus_cos), one_minus_cos,
            [=](const V2f& u) { return sample_uniform_cone(u, one_minus_cos); },
            [=](float) { return uniform_cone_pdf(one_minus_cos); });
    };
    return {
        {"disk",
         [](const V2f& u) {
             const V2f p = sample_uniform_disk(u);
             return V2d(std::hypot(p.x, p.y), turn_of(p.x, p.y));
         },
         [](double s, double) { return uniform_disk_pdf() * s * 2.0 * pi; }},
        cone_shape(
            "sphere", 2.0f, [](const V2f& u) { return sample_uniform_sphere(u); },
            [](float) { return uniform_sphere_pdf(); }),
        cone_shape(
            "cosine hemisphere", 1.0f, [](const V2f& u) { return sample_cosine_hemisphere(u); },
            [](float z) { return cosine_hemisphere_pdf(z); }),
        uniform_cone(0.7f),
        uniform_cone(1.5f),
        {"triangle",
         [](const V2f& u) {
             const V2f b = sample_uniform_triangle(u);
             return V2d(b.x, b.y / (1.0 - double(b.x)));
         },
         [](double s, double) { return uniform_triangle_pdf() * (1.0 - s); }},
    };
}

constexpr int cells_s = 20;
constexpr int cells_t = 40;

double integral_over_cell(const Shape& shape, int i, int j)
{
    constexpr int steps = 8;
    double sum = 0.0;
    for (int a = 0; a < steps; ++a) {
        for (int b = 0; b < steps; ++b) {
            sum += shape.density_st((i + (a + 0.5) / steps) / cells_s,
                                    (j + (b + 0.5) / steps) / cells_t);
        }
    }
    return sum / (steps * steps * cells_s * cells_t);
}

TEST(Warp, samples_follow_their_density)
{
    constexpr int count = 1000000;
    const std::vector<Shape> all = shapes();
    // Sidak: all the shapes together fail by chance once in a hundred seeds.
    const double significance = 1.0 - std::pow(0.99, 1.0 / double(all.size()));
    for (const Shape& shape : all) {
        std::mt19937 generator(1);
        std::uniform_real_distribution<float> uniform(0.0f, 1.0f);
        std::vector<double> observed(cells_s * cells_t);
        std::vector<double> expected(cells_s * cells_t);
        for (int n = 0; n < count; ++n) {
            const float u = uniform(generator);
            const V2d st = shape.sample_st({u, uniform(generator)});
            const int i = std::clamp(int(st.x * cells_s), 0, cells_s - 1);
            const int j = std::clamp(int(st.y * cells_t), 0, cells_t - 1);
            observed[std::size_t(i * cells_t + j)] += 1.0;
        }
        for (int i = 0; i < cells_s; ++i) {
            for (int j = 0; j < cells_t; ++j) {
                expected[std::size_t(i * cells_t + j)] = count * integral_over_cell(shape, i, j);
            }
        }
        const auto [statistic, critical] =
            test::chi_squared_test(observed, expected, significance);
        EXPECT_LT(statistic, critical) << shape.name;
    }
}

TEST(Warp, densities_integrate_to_one)
{
    for (const Shape& shape : shapes()) {
        double total = 0.0;
        for (int i = 0; i < cells_s; ++i) {
            for (int j = 0; j < cells_t; ++j) {
                total += integral_over_cell(shape, i, j);
            }
        }
        EXPECT_NEAR(total, 1.0, 1e-6) << shape.name;
    }
}

template <typename RoundTrip>
void expect_inverse(const char* name, RoundTrip round_trip)
{
    // Rounding of the shape's coordinates, magnified by the steepest warp (the rim of the
    // hemisphere is not among the points).
    constexpr float tolerance = 2e-6f;
    for (int i = 1; i < 64; ++i) {
        for (int j = 1; j < 64; ++j) {
            const V2f u(float(i) / 64.0f, float(j) / 64.0f);
            const V2f back = round_trip(u);
            EXPECT_NEAR(u.x, back.x, tolerance) << name << " at " << u;
            EXPECT_NEAR(u.y, back.y, tolerance) << name << " at " << u;
        }
    }
}

TEST(Warp, inverses_return_the_square)
{
    expect_inverse("disk", [](V2f u) { return invert_uniform_disk(sample_uniform_disk(u)); });
    expect_inverse("triangle",
                   [](V2f u) { return invert_uniform_triangle(sample_uniform_triangle(u)); });
    expect_inverse("hemisphere",
                   [](V2f u) { return invert_cosine_hemisphere(sample_cosine_hemisphere(u)); });
    expect_inverse("sphere",
                   [](V2f u) { return invert_uniform_sphere(sample_uniform_sphere(u)); });
    for (const float one_minus_cos : {1e-5f, 0.1f, 1.0f, 1.9f}) {
        expect_inverse("cone", [=](V2f u) {
            return invert_uniform_cone(sample_uniform_cone(u, one_minus_cos), one_minus_cos);
        });
    }
}

TEST(Warp, directions_are_unit_and_inside_even_at_the_edges_of_the_square)
{
    constexpr float last = 1.0f - 0x1p-24f;
    for (const float x : {0.0f, 0.5f, last}) {
        for (const float y : {0.0f, 0.5f, last}) {
            const V2f u(x, y);
            EXPECT_LE(sample_uniform_disk(u).length(), 1.0f + 1e-6f) << u;
            EXPECT_GE(sample_cosine_hemisphere(u).z, 0.0f) << u;
            EXPECT_NEAR(sample_cosine_hemisphere(u).length(), 1.0f, 1e-6f) << u;
            EXPECT_NEAR(sample_uniform_sphere(u).length(), 1.0f, 1e-6f) << u;
            EXPECT_NEAR(sample_uniform_cone(u, 1e-5f).length(), 1.0f, 1e-6f) << u;
            EXPECT_GE(sample_uniform_cone(u, 1e-5f).z, 1.0f - 1.1e-5f) << u;
            const V2f b = sample_uniform_triangle(u);
            EXPECT_TRUE(b.x >= 0.0f && b.y >= 0.0f && b.x + b.y <= 1.0f) << u;
        }
    }
}

TEST(Warp, the_suns_cone_has_its_width)
{
    // Half angle 0.2665 degrees: 1 - cos is 1.08e-5, where a cosine in float has three digits.
    const double half_angle = rad_from_deg(0.2665);
    const float one_minus_cos = float(2.0 * std::pow(std::sin(0.5 * half_angle), 2));
    const V3f rim = sample_uniform_cone({1.0f - 0x1p-24f, 0.5f}, one_minus_cos);
    EXPECT_NEAR(std::hypot(rim.x, rim.y), std::sin(half_angle), 1e-8);
}

}  // namespace
}  // namespace eye_render
