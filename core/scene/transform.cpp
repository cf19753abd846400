#include "scene/transform.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace eye_render {

namespace {

V3d axis(const M44d& m, int row) { return {m[row][0], m[row][1], m[row][2]}; }

}  // namespace

M44d relative_to_eye(M44d world_from_object, const V3d& eye_position_world)
{
    for (int i = 0; i < 3; ++i) {
        world_from_object[3][i] -= eye_position_world[i];
    }
    return world_from_object;
}

M44f to_float(const M44d& m)
{
    M44f result;
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            result[i][j] = static_cast<float>(m[i][j]);
        }
    }
    return result;
}

bool is_mirror(const M44d& m) { return axis(m, 0).dot(axis(m, 1).cross(axis(m, 2))) < 0.0; }

bool is_invertible(const M44d& m)
{
    // The volume that the axes span, relative to the cube of the longest: 1e-5 leaves two of a
    // float's seven digits.
    constexpr double smallest = 1e-5;
    const V3d x = axis(m, 0);
    const V3d y = axis(m, 1);
    const V3d z = axis(m, 2);
    const double longest = std::max({x.length(), y.length(), z.length()});
    return std::abs(x.dot(y.cross(z))) > smallest * longest * longest * longest;
}

float scale_of(const M44f& m)
{
    const V3f x(m[0][0], m[0][1], m[0][2]);
    const V3f y(m[1][0], m[1][1], m[1][2]);
    const V3f z(m[2][0], m[2][1], m[2][2]);
    return std::cbrt(std::abs(x.dot(y.cross(z))));
}

M33f normal_matrix(const M44d& m)
{
    const V3d x = axis(m, 0);
    const V3d y = axis(m, 1);
    const V3d z = axis(m, 2);
    const std::array rows{y.cross(z), z.cross(x), x.cross(y)};
    // Objects in micrometres would underflow in float.
    double largest = 0.0;
    for (const V3d& row : rows) {
        largest = std::max({largest, std::abs(row.x), std::abs(row.y), std::abs(row.z)});
    }
    const double scale = (is_mirror(m) ? -1.0 : 1.0) / (largest > 0.0 ? largest : 1.0);
    M33f result;
    int row_number = 0;
    for (const V3d& row : rows) {
        for (int column = 0; column < 3; ++column) {
            result[row_number][column] = static_cast<float>(row[column] * scale);
        }
        ++row_number;
    }
    return result;
}

}  // namespace eye_render
