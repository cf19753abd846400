// The dioptric power matrix: a symmetric 2x2 matrix in dioptres, and its algebra.
//
// Long 1976 / Thibos 1997: F = [[M + J0, J45], [J45, M - J0]] = S uu' + (S + C) vv' with u along
// the cylinder axis. A thin lens of power F bends a ray at p (metres) by slope_out = slope_in - F
// p. The frame (TABO or camera) is the caller's and stands in the variable's name.

#pragma once

#include "base/vector.h"

#include <cmath>

namespace eye_render {

struct PowerMatrix {
    double xx_d = 0.0;
    double xy_d = 0.0;
    double yy_d = 0.0;

    [[nodiscard]] static constexpr PowerMatrix sphere(double power_d)
    {
        return {power_d, 0.0, power_d};
    }

    // M of the power vector: the spherical equivalent.
    [[nodiscard]] constexpr double mean_d() const { return 0.5 * (xx_d + yy_d); }
    [[nodiscard]] constexpr double j0_d() const { return 0.5 * (xx_d - yy_d); }
    [[nodiscard]] constexpr double j45_d() const { return xy_d; }

    // Half the cylinder, never negative: the eigenvalues are mean_d() +- astigmatism_d().
    [[nodiscard]] double astigmatism_d() const { return std::hypot(j0_d(), j45_d()); }

    // The larger of the eigenvalues' magnitudes. As an error of an eye, times the pupil's
    // diameter, it is the major diameter of the blur.
    [[nodiscard]] double largest_magnitude_d() const
    {
        return std::abs(mean_d()) + astigmatism_d();
    }

    [[nodiscard]] V2d operator*(const V2d& p) const
    {
        return {xx_d * p.x + xy_d * p.y, xy_d * p.x + yy_d * p.y};
    }
};

[[nodiscard]] constexpr PowerMatrix operator+(const PowerMatrix& a, const PowerMatrix& b)
{
    return {a.xx_d + b.xx_d, a.xy_d + b.xy_d, a.yy_d + b.yy_d};
}

[[nodiscard]] constexpr PowerMatrix operator-(const PowerMatrix& a, const PowerMatrix& b)
{
    return {a.xx_d - b.xx_d, a.xy_d - b.xy_d, a.yy_d - b.yy_d};
}

}  // namespace eye_render
