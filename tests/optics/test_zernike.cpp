// Zernike polynomials against their definition, by quadrature and by finite differences.

#include "optics/zernike.h"

#include "base/units.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace eye_render {
namespace {

constexpr int terms = 28;

PupilPolynomial zernike(const ZernikeTerm& term)
{
    PupilPolynomial polynomial;
    polynomial.add(term, 1.0);
    return polynomial;
}

constexpr std::array points{V2d(0.0, 0.0), V2d(0.3, -0.2), V2d(-0.7, 0.1), V2d(0.0, 0.99),
                            V2d(-0.5, -0.8)};

TEST(Zernike, osa_indices_run_through_the_orders)
{
    EXPECT_EQ(osa_term(0), (ZernikeTerm{0, 0}));
    EXPECT_EQ(osa_term(3), (ZernikeTerm{2, -2}));
    EXPECT_EQ(osa_term(4), (ZernikeTerm{2, 0}));
    EXPECT_EQ(osa_term(8), (ZernikeTerm{3, 1}));
    EXPECT_EQ(osa_term(12), (ZernikeTerm{4, 0}));
    EXPECT_EQ(osa_term(27), (ZernikeTerm{6, 6}));
    for (int j = 0; j < 200; ++j) {
        const ZernikeTerm term = osa_term(j);
        EXPECT_EQ(osa_index(term), j);
        EXPECT_LE(std::abs(term.m), term.n) << j;
        EXPECT_EQ((term.n - term.m) % 2, 0) << j;
    }
}

TEST(Zernike, low_orders_are_the_standards_table)
{
    // Thibos et al. 2002, table 1, in Cartesian form.
    for (const V2d& p : points) {
        SCOPED_TRACE(p);
        const double r2 = p.length2();
        EXPECT_NEAR(zernike({0, 0}).value(p), 1.0, 1e-14);
        EXPECT_NEAR(zernike({1, -1}).value(p), 2.0 * p.y, 1e-14);
        EXPECT_NEAR(zernike({1, 1}).value(p), 2.0 * p.x, 1e-14);
        EXPECT_NEAR(zernike({2, -2}).value(p), std::sqrt(6.0) * 2.0 * p.x * p.y, 1e-14);
        EXPECT_NEAR(zernike({2, 0}).value(p), std::sqrt(3.0) * (2.0 * r2 - 1.0), 1e-14);
        EXPECT_NEAR(zernike({2, 2}).value(p), std::sqrt(6.0) * (p.x * p.x - p.y * p.y), 1e-14);
        EXPECT_NEAR(zernike({3, -1}).value(p), std::sqrt(8.0) * (3.0 * r2 - 2.0) * p.y, 1e-14);
        EXPECT_NEAR(zernike({3, 3}).value(p),
                    std::sqrt(8.0) * (p.x * p.x * p.x - 3.0 * p.x * p.y * p.y), 1e-14);
        EXPECT_NEAR(zernike({4, 0}).value(p), std::sqrt(5.0) * (6.0 * r2 * r2 - 6.0 * r2 + 1.0),
                    1e-14);
    }
}

TEST(Zernike, terms_are_orthonormal_over_the_pupil)
{
    // Midpoints in theta are exact for these frequencies; midpoints in rho^2 converge as the
    // square of their distance.
    constexpr int rings = 400;
    constexpr int spokes = 16;
    std::array<PupilPolynomial, terms> polynomials;
    for (int j = 0; j < terms; ++j) {
        polynomials[static_cast<std::size_t>(j)] = zernike(osa_term(j));
    }
    std::array<std::array<double, terms>, terms> product{};
    for (int ring = 0; ring < rings; ++ring) {
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const double rho = std::sqrt((ring + 0.5) / rings);
            const double theta = 2.0 * pi * (spoke + 0.5) / spokes;
            const V2d p(rho * std::cos(theta), rho * std::sin(theta));
            std::array<double, terms> values{};
            for (std::size_t j = 0; j < terms; ++j) {
                values[j] = polynomials[j].value(p);
            }
            for (std::size_t i = 0; i < terms; ++i) {
                for (std::size_t j = 0; j <= i; ++j) {
                    product[i][j] += values[i] * values[j] / (rings * spokes);
                }
            }
        }
    }
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t j = 0; j <= i; ++j) {
            EXPECT_NEAR(product[i][j], i == j ? 1.0 : 0.0, 1e-3) << i << ", " << j;
        }
    }
}

TEST(Zernike, radial_polynomials_end_at_one_to_high_orders)
{
    for (int n = 0; n <= 20; ++n) {
        for (int m = n % 2; m <= n; m += 2) {
            EXPECT_NEAR(zernike_radial(n, m, 1.0), 1.0, 1e-9) << n << ", " << m;
            EXPECT_EQ(zernike_radial(n, m, 0.0), m > 0 ? 0.0 : (n / 2 % 2 == 0 ? 1.0 : -1.0));
        }
    }
    EXPECT_EQ(zernike_radial(2, 4, 0.5), 0.0);
}

TEST(Zernike, gradient_matches_finite_differences)
{
    constexpr double h = 1e-5;  // error h^2 times a third derivative of at most 10^4
    for (int j = 0; j < terms; ++j) {
        const PupilPolynomial polynomial = zernike(osa_term(j));
        for (const V2d& p : points) {
            const V2d gradient = polynomial.gradient(p);
            const auto slope = [&](const V2d& d) {
                return (polynomial.value(p + d) - polynomial.value(p - d)) / (2.0 * h);
            };
            EXPECT_NEAR(gradient.x, slope({h, 0.0}), 1e-6) << "index " << j << " at " << p;
            EXPECT_NEAR(gradient.y, slope({0.0, h}), 1e-6) << "index " << j << " at " << p;
        }
    }
}

TEST(Zernike, sums_add_up_and_lose_their_low_degrees)
{
    PupilPolynomial sum;
    sum.add({2, 0}, 0.5);
    sum.add({4, 0}, -2.0);
    sum.add({3, -1}, 1.5);
    const V2d p(0.4, -0.3);
    EXPECT_NEAR(sum.value(p),
                0.5 * zernike({2, 0}).value(p) - 2.0 * zernike({4, 0}).value(p) +
                    1.5 * zernike({3, -1}).value(p),
                1e-14);
    sum.drop_below(3);
    const double r2 = p.length2();
    EXPECT_NEAR(sum.value(p), -12.0 * std::sqrt(5.0) * r2 * r2 + 4.5 * std::sqrt(8.0) * r2 * p.y,
                1e-14);
}

TEST(Zernike, an_empty_sum_is_flat)
{
    EXPECT_EQ(PupilPolynomial{}.value({0.3, 0.4}), 0.0);
    EXPECT_EQ(PupilPolynomial{}.gradient({0.3, 0.4}), V2d(0.0));
    EXPECT_EQ(PupilPolynomial{}.second_degree().round, 0.0);
}

}  // namespace
}  // namespace eye_render
