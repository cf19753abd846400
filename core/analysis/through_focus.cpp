// With slopes s and crossings o about their means, a ray's miss at vergence X is s + X o. Its mean
// square is a parabola in X, and regression of s on o gives K.

#include "analysis/through_focus.h"

namespace eye_render {

namespace {

// Central second moments of the slopes (s) and of the crossings (o).
struct Moments {
    double so_xx = 0.0;
    double so_xy = 0.0;
    double so_yx = 0.0;
    double so_yy = 0.0;
    double oo_xx = 0.0;
    double oo_xy = 0.0;
    double oo_yy = 0.0;
};

Moments moments_of(const PupilTrace& trace)
{
    double weight = 0.0;
    V2d mean_s(0.0);
    V2d mean_o(0.0);
    for (const TracedRay& ray : trace.rays) {
        weight += ray.weight;
        mean_s += ray.line.slope * ray.weight;
        mean_o += ray.line.crossing_m * ray.weight;
    }
    Moments m;
    if (weight <= 0.0) {
        return m;
    }
    mean_s /= weight;
    mean_o /= weight;
    for (const TracedRay& ray : trace.rays) {
        const double share = ray.weight / weight;
        const V2d s = ray.line.slope - mean_s;
        const V2d o = ray.line.crossing_m - mean_o;
        m.so_xx += share * s.x * o.x;
        m.so_xy += share * s.x * o.y;
        m.so_yx += share * s.y * o.x;
        m.so_yy += share * s.y * o.y;
        m.oo_xx += share * o.x * o.x;
        m.oo_xy += share * o.x * o.y;
        m.oo_yy += share * o.y * o.y;
    }
    return m;
}

// The symmetric part of K = -so oo^-1, which makes s + K o least.
PowerMatrix regression(const Moments& m)
{
    const double determinant = m.oo_xx * m.oo_yy - m.oo_xy * m.oo_xy;
    if (!(determinant > 0.0)) {
        return {};
    }
    const double xx = (m.so_xx * m.oo_yy - m.so_xy * m.oo_xy) / determinant;
    const double xy = (m.so_xy * m.oo_xx - m.so_xx * m.oo_xy) / determinant;
    const double yx = (m.so_yx * m.oo_yy - m.so_yy * m.oo_xy) / determinant;
    const double yy = (m.so_yy * m.oo_xx - m.so_yx * m.oo_xy) / determinant;
    return {-xx, -0.5 * (xy + yx), -yy};
}

}  // namespace

ThroughFocus through_focus(const PupilTrace& trace)
{
    const Moments m = moments_of(trace);
    const double oo = m.oo_xx + m.oo_yy;
    if (!(oo > 0.0)) {
        return {};
    }
    return {.best_focus_d = -(m.so_xx + m.so_yy) / oo, .conjugate_d = regression(m)};
}

ThroughFocus through_focus(const EyeModel& eye)
{
    // Regression needs fewer rays than a picture: an eye without higher aberrations is exact with
    // any number of them.
    constexpr std::uint32_t rays = 4096;
    return through_focus(trace_pupil(eye, {.samples = rays}));
}

}  // namespace eye_render
