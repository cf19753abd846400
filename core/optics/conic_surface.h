// A refracting surface of second order, and Snell's law.
//
// Frame: z along the light that enters the eye, the surface's vertex on the z axis. The sag of a
// biconic with the curvatures c and conic constants Q of its two principal meridians x and y is
//     z = N / (1 + sqrt(1 - (1 + Qx) cx^2 x^2 - (1 + Qy) cy^2 y^2)),  N = cx x^2 + cy y^2,
// and with equal meridians it is the conic c r^2 / (1 + sqrt(1 - (1 + Q) c^2 r^2)). Lengths in
// metres. Failure is an empty optional.

#pragma once

#include "base/vector.h"

#include <optional>

namespace eye_render {

// A line with a sense. The direction is of unit length.
struct OpticalRay {
    V3d origin_m{0.0};
    V3d direction{0.0, 0.0, 1.0};
};

struct ConicSurface {
    double vertex_m = 0.0;           // on the z axis
    double curvature_x_per_m = 0.0;  // 1/radius; positive when the centre lies at larger z
    double curvature_y_per_m = 0.0;
    double conic_x = 0.0;  // Q: 0 sphere, -1 paraboloid, below -1 hyperboloid
    double conic_y = 0.0;

    // Equal in all meridians; a radius of infinity is a plane.
    [[nodiscard]] static ConicSurface of_revolution(double vertex_m, double radius_m, double conic)
    {
        return {vertex_m, 1.0 / radius_m, 1.0 / radius_m, conic, conic};
    }

    [[nodiscard]] bool is_of_revolution() const
    {
        return curvature_x_per_m == curvature_y_per_m && conic_x == conic_y;
    }

    // Height above the vertex plane; nothing beyond the rim, where the root is of a negative.
    [[nodiscard]] std::optional<double> sag_m(double x_m, double y_m) const;

    // Unit normal at a point of the surface, towards larger z on the sheet of the vertex.
    [[nodiscard]] V3d normal(const V3d& point_m) const;

    // Where the line of `ray`, taken in both senses, crosses the surface on its way to larger z:
    // for a sphere it enters a convex one (c > 0) and leaves a concave one (c < 0), whether this
    // is in the vertex's half or not. Nothing when it misses or runs across the axis.
    [[nodiscard]] std::optional<V3d> intersection(const OpticalRay& ray) const;

    // Whether a point of the surface is in the half (the sheet, the ellipsoid's cap) with the
    // vertex. A biconic has no other.
    [[nodiscard]] bool is_on_vertex_side(const V3d& point_m) const;
};

// The unit direction behind a surface. The normal may point either way. `index_ratio` is that
// before the surface over that behind. Nothing at total reflection.
[[nodiscard]] std::optional<V3d> refracted(const V3d& direction,
                                           const V3d& normal,
                                           double index_ratio);

}  // namespace eye_render
