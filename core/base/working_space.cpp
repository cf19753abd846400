// All matrices follow from the published chromaticities, when this is compiled. They act on
// columns: xyz = xyz_from_rgb * rgb.

#include "base/working_space.h"

#include <array>
#include <cstddef>

namespace eye_render {

namespace {

using Column = std::array<double, 3>;
using Matrix = std::array<Column, 3>;  // rows

constexpr Column operator*(const Matrix& m, const Column& v)
{
    Column product{};
    for (std::size_t row = 0; row < 3; ++row) {
        product[row] = m[row][0] * v[0] + m[row][1] * v[1] + m[row][2] * v[2];
    }
    return product;
}

constexpr Matrix operator*(const Matrix& a, const Matrix& b)
{
    Matrix product{};
    for (std::size_t column = 0; column < 3; ++column) {
        const Column image = a * Column{b[0][column], b[1][column], b[2][column]};
        for (std::size_t row = 0; row < 3; ++row) {
            product[row][column] = image[row];
        }
    }
    return product;
}

constexpr Matrix diagonal(const Column& d)
{
    return {{{d[0], 0.0, 0.0}, {0.0, d[1], 0.0}, {0.0, 0.0, d[2]}}};
}

constexpr Matrix inverse(const Matrix& m)
{
    // Rows and columns counted on from one's own, around the matrix, give cofactors their sign.
    const auto cofactor = [&m](std::size_t row, std::size_t column) {
        const std::size_t r1 = (row + 1) % 3;
        const std::size_t r2 = (row + 2) % 3;
        const std::size_t c1 = (column + 1) % 3;
        const std::size_t c2 = (column + 2) % 3;
        return m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
    };
    const double determinant =
        m[0][0] * cofactor(0, 0) + m[0][1] * cofactor(0, 1) + m[0][2] * cofactor(0, 2);
    Matrix result{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            result[j][i] = cofactor(i, j) / determinant;
        }
    }
    return result;
}

struct Chromaticity {
    double x, y;

    [[nodiscard]] constexpr Column xyz() const { return {x / y, 1.0, (1.0 - x - y) / y}; }
};

struct Primaries {
    Chromaticity red, green, blue;
    Column white;
};

// ASTM E308, 2 degree observer.
constexpr Column d65{0.95047, 1.0, 1.08883};

constexpr std::array<Primaries, 3> published{{
    {{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}, d65},
    {{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, d65},
    {{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}, Chromaticity{0.32168, 0.33767}.xyz()},
}};

// SMPTE RP 177: the primaries in the amounts that together are white.
constexpr Matrix xyz_of_own_white(const Primaries& of)
{
    const Column red = of.red.xyz();
    const Column green = of.green.xyz();
    const Column blue = of.blue.xyz();
    const Matrix primaries{
        {{red[0], green[0], blue[0]}, {red[1], green[1], blue[1]}, {red[2], green[2], blue[2]}}};
    return primaries * diagonal(inverse(primaries) * of.white);
}

// Scales the responses of Bradford's cones from one white to D65.
constexpr Matrix adapted_to_d65(const Column& white)
{
    constexpr Matrix cones{
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const Column from = cones * white;
    const Column to = cones * d65;
    return inverse(cones) * diagonal({to[0] / from[0], to[1] / from[1], to[2] / from[2]}) * cones;
}

using Rows = std::array<V3f, 3>;

constexpr V3f rounded(const Column& row)
{
    return {static_cast<float>(row[0]), static_cast<float>(row[1]), static_cast<float>(row[2])};
}

constexpr Rows rounded(const Matrix& m) { return {rounded(m[0]), rounded(m[1]), rounded(m[2])}; }

struct Transforms {
    Rows xyz_from_rgb;
    Rows rgb_from_xyz;
    Rows rgb_from_rec709;
};

constexpr Transforms make_transforms(const Primaries& primaries)
{
    const Matrix xyz = adapted_to_d65(primaries.white) * xyz_of_own_white(primaries);
    return {.xyz_from_rgb = rounded(xyz),
            .rgb_from_xyz = rounded(inverse(xyz)),
            .rgb_from_rec709 = rounded(inverse(xyz) * xyz_of_own_white(published[0]))};
}

constexpr std::array<Transforms, 3> transforms{
    make_transforms(published[0]), make_transforms(published[1]), make_transforms(published[2])};

const Transforms& transforms_of(WorkingSpace space)
{
    return transforms[static_cast<std::size_t>(space)];
}

V3f product(const Rows& rows, const V3f& v)
{
    return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)};
}

}  // namespace

Color3f rgb_from_xyz(const V3f& xyz, WorkingSpace space)
{
    return product(transforms_of(space).rgb_from_xyz, xyz);
}

V3f xyz_from_rgb(const Color3f& rgb, WorkingSpace space)
{
    return product(transforms_of(space).xyz_from_rgb, rgb);
}

Color3f rgb_from_rec709(const Color3f& rec709, WorkingSpace space)
{
    return space == WorkingSpace::Rec709
               ? rec709
               : Color3f(product(transforms_of(space).rgb_from_rec709, rec709));
}

V3f luminance_weights(WorkingSpace space) { return transforms_of(space).xyz_from_rgb[1]; }

}  // namespace eye_render
