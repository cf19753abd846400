#include "optics/paraxial_trace.h"

namespace eye_render {

namespace {

double curvature_per_m(const ConicSurface& shape, Meridian meridian)
{
    return meridian == Meridian::X ? shape.curvature_x_per_m : shape.curvature_y_per_m;
}

double cornea_m(const LensSystem& system) { return system.surfaces.front().shape.vertex_m; }

}  // namespace

RayMatrix moved_along(const RayMatrix& before, double distance_m, double index)
{
    const double reduced_m = distance_m / index;
    return {before.a + reduced_m * before.c_per_m, before.b_m + reduced_m * before.d,
            before.c_per_m, before.d};
}

RayMatrix ray_matrix(const LensSystem& system,
                     const Indices& indices,
                     Meridian meridian,
                     std::size_t first,
                     std::size_t last)
{
    RayMatrix m;
    for (std::size_t i = first; i < last; ++i) {
        const ConicSurface& shape = system.surfaces[i].shape;
        if (i > first) {
            const double from_m = system.surfaces[i - 1].shape.vertex_m;
            m = moved_along(m, shape.vertex_m - from_m, indices[i]);
        }
        const double power_d = (indices[i + 1] - indices[i]) * curvature_per_m(shape, meridian);
        m.c_per_m -= power_d * m.a;
        m.d -= power_d * m.b_m;
    }
    return m;
}

EntrancePupil entrance_pupil(const LensSystem& system, const Indices& indices, Meridian meridian)
{
    const std::size_t before_stop = system.lens - 1;
    const RayMatrix to_stop = moved_along(
        ray_matrix(system, indices, meridian, 0, system.lens),
        system.stop_m - system.surfaces[before_stop].shape.vertex_m, indices[system.lens]);
    return {.position_m = to_stop.b_m / to_stop.a, .magnification = 1.0 / to_stop.a};
}

double conjugate_vergence_d(const LensSystem& system,
                            const Indices& indices,
                            Meridian meridian,
                            double plane_m)
{
    const std::size_t count = system.surfaces.size();
    const RayMatrix to_retina = moved_along(
        ray_matrix(system, indices, meridian, 0, count),
        system.retina.vertex_m - system.surfaces.back().shape.vertex_m, indices[count]);
    // A point on the axis at vergence X sends angle = X height, and its image height a + b X is 0.
    return -to_retina.a / (to_retina.b_m - plane_m * to_retina.a);
}

CardinalPoints cardinal_points(const LensSystem& system, const Indices& indices, Meridian meridian)
{
    const std::size_t count = system.surfaces.size();
    const RayMatrix m = ray_matrix(system, indices, meridian, 0, count);
    const double n = indices[count];
    const double last_m = system.surfaces.back().shape.vertex_m - cornea_m(system);
    CardinalPoints points;
    points.power_d = -m.c_per_m;
    points.principal_m = (1.0 - m.d) / points.power_d;
    points.principal_retinal_m = last_m - n * (1.0 - m.a) / points.power_d;
    const double nodal_shift_m = (n - 1.0) / points.power_d;
    points.nodal_m = points.principal_m + nodal_shift_m;
    points.nodal_retinal_m = points.principal_retinal_m + nodal_shift_m;
    points.back_vertex_focal_m = n * m.a / points.power_d;
    return points;
}

}  // namespace eye_render
