#include "optics/conic_surface.h"

#include <cmath>

namespace eye_render {

namespace {

// Sag of a biconic and its slopes, at (x, y) from the axis.
struct SagAndSlopes {
    double sag_m = 0.0;
    double along_x = 0.0;
    double along_y = 0.0;
};

std::optional<SagAndSlopes> sag_and_slopes(const ConicSurface& s, double x_m, double y_m)
{
    const double cx = s.curvature_x_per_m;
    const double cy = s.curvature_y_per_m;
    const double px = (1.0 + s.conic_x) * cx * cx;
    const double py = (1.0 + s.conic_y) * cy * cy;
    const double square = 1.0 - px * x_m * x_m - py * y_m * y_m;
    if (!(square > 0.0)) return std::nullopt;
    const double root = std::sqrt(square);
    const double scale = 1.0 / (1.0 + root);
    const double sag_m = (cx * x_m * x_m + cy * y_m * y_m) * scale;
    return SagAndSlopes{sag_m, x_m * (2.0 * cx + sag_m * px / root) * scale,
                        y_m * (2.0 * cy + sag_m * py / root) * scale};
}

// The crossing with c (x^2 + y^2 + (1 + Q) z^2) - 2 z = 0, which is negative on the far side of
// the sheet with the vertex. `start_m` lies in the vertex plane, `d` runs to larger z; the result
// is how far along d.
std::optional<double> conic_crossing_m(double c, double q, const V3d& start_m, const V3d& d)
{
    const double a = c * (1.0 + q * d.z * d.z);
    const double b = c * (start_m.x * d.x + start_m.y * d.y) - d.z;
    const double e = c * (start_m.x * start_m.x + start_m.y * start_m.y);
    const double square = b * b - a * e;
    if (!(square >= 0.0)) return std::nullopt;
    // Of the two roots that at which the function falls, a t + b = -sqrt: it is on the right sheet
    // of a hyperboloid, too. The two forms of it lose no digits for their own sign of b.
    const double root = std::sqrt(square);
    const double t_m = b <= 0.0 ? e / (root - b) : -(b + root) / a;
    if (!std::isfinite(t_m)) return std::nullopt;
    return t_m;
}

// Newton's method from the crossing with the conic of mean curvature, which is near.
std::optional<double> biconic_crossing_m(const ConicSurface& s, const V3d& start_m, const V3d& d)
{
    const auto guess_m = conic_crossing_m(0.5 * (s.curvature_x_per_m + s.curvature_y_per_m),
                                          0.5 * (s.conic_x + s.conic_y), start_m, d);
    if (!guess_m) return std::nullopt;
    double t_m = *guess_m;
    // Convergence is quadratic: what follows a step of 1e-10 m is below the last digit.
    constexpr double last_step_m = 1e-10;
    constexpr int max_steps = 20;
    for (int step = 0; step < max_steps; ++step) {
        const V3d p_m = start_m + d * t_m;
        const auto sag = sag_and_slopes(s, p_m.x, p_m.y);
        if (!sag) return std::nullopt;
        const double slope = d.z - sag->along_x * d.x - sag->along_y * d.y;
        if (!(slope > 0.0)) return std::nullopt;
        const double step_m = (p_m.z - sag->sag_m) / slope;
        t_m -= step_m;
        if (std::abs(step_m) < last_step_m) return t_m;
    }
    return std::nullopt;
}

}  // namespace

std::optional<double> ConicSurface::sag_m(double x_m, double y_m) const
{
    const auto result = sag_and_slopes(*this, x_m, y_m);
    if (!result) return std::nullopt;
    return result->sag_m;
}

V3d ConicSurface::normal(const V3d& point_m) const
{
    if (is_of_revolution()) {
        const double c = curvature_x_per_m;
        return V3d(-c * point_m.x, -c * point_m.y,
                   1.0 - (1.0 + conic_x) * c * (point_m.z - vertex_m))
            .normalized();
    }
    const auto slopes = sag_and_slopes(*this, point_m.x, point_m.y);
    return slopes ? V3d(-slopes->along_x, -slopes->along_y, 1.0).normalized() : V3d(0.0, 0.0, 1.0);
}

std::optional<V3d> ConicSurface::intersection(const OpticalRay& ray) const
{
    // Below this a ray runs across the axis and its crossing with the vertex plane is far off.
    constexpr double least_z = 1e-9;
    const double toward_retina = ray.direction.z < 0.0 ? -1.0 : 1.0;
    const V3d d = ray.direction * toward_retina;
    if (!(d.z > least_z)) return std::nullopt;
    // From the vertex plane the crossing is near, however distant the ray's origin is.
    const V3d from_vertex_m = ray.origin_m - V3d(0.0, 0.0, vertex_m);
    const V3d start_m = from_vertex_m - d * (from_vertex_m.z / d.z);
    const auto t_m = is_of_revolution() ? conic_crossing_m(curvature_x_per_m, conic_x, start_m, d)
                                        : biconic_crossing_m(*this, start_m, d);
    if (!t_m) return std::nullopt;
    return start_m + d * *t_m + V3d(0.0, 0.0, vertex_m);
}

bool ConicSurface::is_on_vertex_side(const V3d& point_m) const
{
    return !is_of_revolution() ||
           (1.0 + conic_x) * curvature_x_per_m * (point_m.z - vertex_m) < 1.0;
}

std::optional<V3d> refracted(const V3d& direction, const V3d& normal, double index_ratio)
{
    const double along = direction.dot(normal);
    const double square = 1.0 - index_ratio * index_ratio * (1.0 - along * along);
    if (!(square >= 0.0)) return std::nullopt;
    const double along_behind = std::copysign(std::sqrt(square), along);
    return direction * index_ratio + normal * (along_behind - index_ratio * along);
}

}  // namespace eye_render
