#include "eye/schematic_rays.h"

#include "optics/paraxial_trace.h"

#include <cmath>

namespace eye_render {

namespace {

// Broyden's method for two equations in two unknowns, sines, with a first Jacobian by differences.
// `function` returns a Sought; |value| below `tolerance` is found. When the guess itself does not
// pass, neither does what is sought.
//
// Nothing that is not finite is ever found. No comparison with NaN is true, so a NaN value never
// is below the tolerance; a Jacobian without inverse makes a step that is infinite or NaN, where
// no ray passes; and then what is sought counts as missed.
template <typename Function>
Sought root_in_plane(const Function& function, const V2d& guess, double tolerance)
{
    // Where rounding of the value, 1e-16, and the curvature of what is sought cost the Jacobian
    // about equally: both are below 1e-4 of it for functions that bend over a sine of 1.
    constexpr double difference = 1e-4;
    // Within 20 degrees of the axis it takes 3 to 5, and 7 at most; at 70 degrees 4 to 7, and once
    // in 36,000 searches 26. The 2 in 1000 that have not ended there after 30 run in a circle.
    constexpr int max_steps = 30;
    // A step out of the lens, to 1/64: then the root itself is taken to lie outside.
    constexpr int max_halvings = 6;

    V2d x = guess;
    Sought f = function(x);
    if (f.fate != TraceFate::Passed) return f;
    Sought fx = function(x + V2d(difference, 0.0));
    if (fx.fate != TraceFate::Passed) return fx;
    Sought fy = function(x + V2d(0.0, difference));
    if (fy.fate != TraceFate::Passed) return fy;
    // Columns of the Jacobian.
    V2d jx = (fx.value - f.value) / difference;
    V2d jy = (fy.value - f.value) / difference;
    for (int step = 0; step < max_steps; ++step) {
        if (f.value.length() < tolerance) return {.value = x};
        const double determinant = jx.cross(jy);
        V2d dx = V2d(-f.value.cross(jy), f.value.cross(jx)) / determinant;
        Sought next = function(x + dx);
        for (int i = 0; i < max_halvings && next.fate != TraceFate::Passed; ++i) {
            dx *= 0.5;
            next = function(x + dx);
        }
        if (next.fate != TraceFate::Passed) return next;
        // dx is no shorter than what moves the value by the tolerance, so its square is above 0.
        const V2d missing = (next.value - f.value - jx * dx.x - jy * dx.y) / dx.length2();
        jx += missing * dx.x;
        jy += missing * dx.y;
        x += dx;
        f = next;
    }
    return {.fate = TraceFate::Missed};
}

}  // namespace

OpticalRay stop_ray(const LensSystem& system, const V2d& stop_point_m, const V2d& sines)
{
    return {{stop_point_m.x, stop_point_m.y, system.stop_m},
            {sines.x, sines.y, std::sqrt(std::max(0.0, 1.0 - sines.length2()))}};
}

Sought stop_point(const LensSystem& system, const Indices& indices, const V2d& pupil_point_m)
{
    constexpr double before_eye_m = -10e-3;
    const TraceResult traced = traced_inward(
        system, indices, {{pupil_point_m.x, pupil_point_m.y, before_eye_m}, {0.0, 0.0, 1.0}}, 0,
        system.lens);
    const V3d point_m = at_plane(traced.ray, system.stop_m).origin_m;
    return {traced.fate, {point_m.x, point_m.y}};
}

Sought chief_sines(const LensSystem& system, const Indices& indices, const V2d& object_sines)
{
    // Of a sine: fifty roundings of 1, as many as four surfaces and the axis make.
    constexpr double tolerance = 1e-14;
    const double angular_magnification =
        entrance_pupil(system, indices, Meridian::X).magnification / indices[system.lens];
    return root_in_plane(
        [&](const V2d& sines) -> Sought {
            if (!(sines.length2() < 1.0)) return {.fate = TraceFate::Missed};
            const TraceResult traced = object_ray(system, indices, V2d(0.0), sines);
            const V3d& out = traced.ray.direction;
            // A ray bent beyond a right angle has passed the sine that is sought.
            if (traced.fate == TraceFate::Passed && out.z >= 0.0) {
                return {.fate = TraceFate::Missed};
            }
            return {traced.fate, -V2d(out.x, out.y) - object_sines};
        },
        object_sines* angular_magnification, tolerance);
}

Sought sines_to_retina(const LensSystem& system,
                       const Indices& indices,
                       const V2d& stop_point_m,
                       const V3d& retina_point_m,
                       const V2d& chief)
{
    // Seen from the pupil, 17 mm away, 6e-14 of a sine, as in the search for the chief ray; and
    // fifty roundings of the millimetres that points on a retina have.
    constexpr double tolerance_m = 1e-15;
    const std::size_t count = system.surfaces.size();
    const RayMatrix m = moved_along(ray_matrix(system, indices, Meridian::X, system.lens, count),
                                    system.retina.vertex_m - system.surfaces.back().shape.vertex_m,
                                    indices[count]);
    // To first order the retina's height is a (height at the stop) + b (index x angle).
    const double sine_per_m = m.a / (m.b_m * indices[system.lens]);

    const V3d normal = system.retina.normal(retina_point_m);
    const V3d along_x = (V3d(1.0, 0.0, 0.0) - normal * normal.x).normalized();
    const V3d along_y = normal.cross(along_x);
    return root_in_plane(
        [&](const V2d& sines) -> Sought {
            if (!(sines.length2() < 1.0)) return {.fate = TraceFate::Missed};
            const TraceResult traced = traced_to_retina(
                system, indices, stop_ray(system, stop_point_m, sines), system.lens);
            const V3d beside_m = traced.ray.origin_m - retina_point_m;
            return {traced.fate, {beside_m.dot(along_x), beside_m.dot(along_y)}};
        },
        chief - stop_point_m * sine_per_m, tolerance_m);
}

TraceResult object_ray(const LensSystem& system,
                       const Indices& indices,
                       const V2d& stop_point_m,
                       const V2d& sines)
{
    OpticalRay ray = stop_ray(system, stop_point_m, sines);
    ray.direction = -ray.direction;
    return traced_outward(system, indices, ray, 0, system.lens);
}

}  // namespace eye_render
