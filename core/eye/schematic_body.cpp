#include "eye/schematic_body.h"

#include "base/error.h"
#include "base/units.h"
#include "eye/schematic_rays.h"
#include "optics/paraxial_trace.h"
#include "optics/root.h"

#include <cmath>

namespace eye_render {

namespace {

constexpr double min_vitreous_m = 1e-3;
constexpr double max_vitreous_m = 60e-3;
constexpr double min_corneal_radius_m = 3e-3;
constexpr double max_corneal_radius_m = 40e-3;

// The vergence that a point must have for its blur to be least: of the rays that leave the
// retina's axial point, at heights x and with slopes m at the entrance pupil, the one minimising
// the sum of (m + X x)^2. Rings of equal area; by symmetry one meridian is enough.
double least_spot_conjugate_d(const LensSystem& system,
                              const Indices& indices,
                              double plane_m,
                              double pupil_diameter_m)
{
    constexpr int rings = 64;
    const V3d fovea_m(0.0, 0.0, system.retina.vertex_m);
    double slope_height_m = 0.0;
    double height_height_m2 = 0.0;
    for (int ring = 0; ring < rings; ++ring) {
        const double height_m = 0.5 * pupil_diameter_m * std::sqrt((ring + 0.5) / rings);
        const Sought stop_m = stop_point(system, indices, {height_m, 0.0});
        if (stop_m.fate != TraceFate::Passed) continue;
        const Sought sines = sines_to_retina(system, indices, stop_m.value, fovea_m, V2d(0.0));
        if (sines.fate != TraceFate::Passed) continue;
        const TraceResult traced = object_ray(system, indices, stop_m.value, sines.value);
        if (traced.fate != TraceFate::Passed) continue;
        const OpticalRay ray = at_plane(traced.ray, plane_m);
        const double slope = -ray.direction.x / ray.direction.z;
        slope_height_m += slope * ray.origin_m.x;
        height_height_m2 += ray.origin_m.x * ray.origin_m.x;
    }
    return -slope_height_m / height_height_m2;
}

// An eye of this axial length at rest or accommodated.
struct Accommodated {
    LensSystem system;
    double max_accommodation_d = 0.0;
};

// The eye accommodated by what is asked for.
Accommodated accommodated(const SchematicSpec& spec, double axial_m)
{
    const auto system_at = [&](double nominal_d) {
        LensSystem system = schematic_eye(spec.kind, nominal_d);
        system.retina.vertex_m = axial_m;
        return system;
    };
    const auto conjugate_d = [&](double nominal_d) {
        return mean_conjugate_d(system_at(nominal_d), spec.zero, spec.pupil_diameter_m);
    };
    const double relaxed_d = conjugate_d(0.0);
    const double max_nominal_d = max_nominal_accommodation_d(spec.kind);
    const double max_d = std::min(conjugate_d(max_nominal_d) - relaxed_d, max_accommodation_d);
    require_range("accommodation_d", spec.accommodation_d, 0.0, max_d, "D");
    // Less would be lost in the rounding of the conjugates that it is the difference of.
    constexpr double least_d = 1e-9;
    if (spec.accommodation_d < least_d) return {system_at(0.0), max_d};
    const auto nominal_d = bracketed_root(
        [&](double tried_d) { return conjugate_d(tried_d) - relaxed_d - spec.accommodation_d; },
        0.0, max_nominal_d);
    return {system_at(nominal_d.value()), max_d};
}

}  // namespace

double mean_conjugate_d(const LensSystem& system,
                        RefractionZero zero,
                        double pupil_diameter_m,
                        double wavelength_nm)
{
    // A narrower pupil's spot has no aberration left, only rounding.
    constexpr double narrow_m = 1e-5;
    const Indices indices = indices_at(system, wavelength_nm);
    const double plane_m = entrance_pupil(system, indices, Meridian::X).position_m;
    if (zero == RefractionZero::Paraxial || pupil_diameter_m < narrow_m) {
        return conjugate_vergence_d(system, indices, Meridian::X, plane_m);
    }
    return least_spot_conjugate_d(system, indices, plane_m, pupil_diameter_m);
}

double axial_length_m(LensSystem system,
                      double conjugate_d,
                      RefractionZero zero,
                      double pupil_diameter_m,
                      double wavelength_nm)
{
    const double lens_back_m = system.surfaces.back().shape.vertex_m;
    const auto conjugate_at = [&](double vitreous_m) {
        system.retina.vertex_m = lens_back_m + vitreous_m;
        return mean_conjugate_d(system, zero, pupil_diameter_m, wavelength_nm);
    };
    const auto vitreous_m =
        bracketed_root([&](double tried_m) { return conjugate_at(tried_m) - conjugate_d; },
                       min_vitreous_m, max_vitreous_m);
    if (!vitreous_m) {
        throw std::invalid_argument("mean sphere of rx is " + number_text(-conjugate_d) +
                                    " D at the entrance pupil; expected " +
                                    number_text(-conjugate_at(max_vitreous_m)) + " to " +
                                    number_text(-conjugate_at(min_vitreous_m)) + " D in this eye");
    }
    return lens_back_m + *vitreous_m;
}

double anterior_radius_m(LensSystem system,
                         double conjugate_d,
                         double plane_m,
                         double wavelength_nm)
{
    const Indices indices = indices_at(system, wavelength_nm);
    const auto conjugate_at = [&](double curvature_per_m) {
        system.surfaces.front().shape.curvature_x_per_m = curvature_per_m;
        return conjugate_vergence_d(system, indices, Meridian::X, plane_m);
    };
    const auto curvature_per_m =
        bracketed_root([&](double tried_per_m) { return conjugate_at(tried_per_m) - conjugate_d; },
                       1.0 / max_corneal_radius_m, 1.0 / min_corneal_radius_m);
    if (!curvature_per_m) {
        throw std::invalid_argument("a meridian of rx is " + number_text(-conjugate_d) +
                                    " D at the entrance pupil; expected " +
                                    number_text(-conjugate_at(1.0 / min_corneal_radius_m)) +
                                    " to " +
                                    number_text(-conjugate_at(1.0 / max_corneal_radius_m)) +
                                    " D in an eye of this length");
    }
    return 1.0 / *curvature_per_m;
}

SchematicBody schematic_body(const SchematicSpec& spec)
{
    const PowerMatrix relaxed_d = PowerMatrix{} - spec.rx_entrance_pupil_d;
    const LensSystem published = schematic_eye(spec.kind, 0.0);
    const double axial_m =
        axial_length_m(published, relaxed_d.mean_d(), spec.zero, spec.pupil_diameter_m);

    SchematicBody body;
    auto [system, max_d] = accommodated(spec, axial_m);
    body.system = std::move(system);
    body.max_accommodation_d = max_d;
    const Indices indices = indices_at(body.system, reference_wavelength_nm);
    body.entrance_pupil_m = entrance_pupil(body.system, indices, Meridian::X).position_m;
    const double mean_d = mean_conjugate_d(body.system, spec.zero, spec.pupil_diameter_m);
    const double paraxial_d =
        conjugate_vergence_d(body.system, indices, Meridian::X, body.entrance_pupil_m);
    body.retinal_conjugate_d = PowerMatrix::sphere(mean_d);
    const double astigmatism_d = relaxed_d.astigmatism_d();
    if (astigmatism_d == 0.0) return body;

    // The relaxed eye's cornea, which accommodation leaves as it is.
    LensSystem relaxed = published;
    relaxed.retina.vertex_m = axial_m;
    const Indices relaxed_indices = indices_at(relaxed, reference_wavelength_nm);
    const double plane_m = entrance_pupil(relaxed, relaxed_indices, Meridian::X).position_m;
    const double relaxed_paraxial_d =
        conjugate_vergence_d(relaxed, relaxed_indices, Meridian::X, plane_m);
    ConicSurface& cornea = body.system.surfaces.front().shape;
    cornea.curvature_x_per_m =
        1.0 / anterior_radius_m(relaxed, relaxed_paraxial_d + astigmatism_d, plane_m);
    cornea.curvature_y_per_m =
        1.0 / anterior_radius_m(relaxed, relaxed_paraxial_d - astigmatism_d, plane_m);
    // The system's x is the more myopic meridian.
    const double angle_rad = 0.5 * std::atan2(relaxed_d.j45_d(), relaxed_d.j0_d());
    body.axis_x_camera = {std::cos(angle_rad), std::sin(angle_rad)};
    const double x_d =
        conjugate_vergence_d(body.system, indices, Meridian::X, body.entrance_pupil_m) + mean_d -
        paraxial_d;
    const double y_d =
        conjugate_vergence_d(body.system, indices, Meridian::Y, body.entrance_pupil_m) + mean_d -
        paraxial_d;
    const double m_d = 0.5 * (x_d + y_d);
    const double j_d = 0.5 * (x_d - y_d);
    const double j0_d = j_d * std::cos(2.0 * angle_rad);
    body.retinal_conjugate_d = {m_d + j0_d, j_d * std::sin(2.0 * angle_rad), m_d - j0_d};
    return body;
}

}  // namespace eye_render
