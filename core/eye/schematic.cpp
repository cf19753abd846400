// Rays by the exact trace or by the fitted maps; see schematic_maps.h.

#include "eye/schematic.h"

#include "eye/schematic_body.h"
#include "eye/schematic_rays.h"

#include <cmath>

namespace eye_render {

namespace {

RayFate ray_fate(TraceFate fate)
{
    switch (fate) {
    case TraceFate::Passed: return RayFate::Transmitted;
    case TraceFate::Vignetted: return RayFate::Vignetted;
    case TraceFate::Missed: return RayFate::Missed;
    case TraceFate::TotalReflection: return RayFate::TotalReflection;
    }
    return RayFate::Missed;
}

EyeRay lost(TraceFate fate) { return {.fate = ray_fate(fate), .weight = 0.0}; }

class TracedEye final : public SchematicEye {
public:
    TracedEye(const SchematicBody& body, double pupil_diameter_m)
        : body_(body), reference_(indices_at(body.system, reference_wavelength_nm)),
          pupil_diameter_m_(pupil_diameter_m)
    {
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double wavelength_nm) const override
    {
        const LensSystem& system = body_.system;
        const V2d object_sines =
            -to_system(chief_slope) / std::hypot(1.0, chief_slope.x, chief_slope.y);
        const Indices indices =
            indices_at(system, std::clamp(wavelength_nm, min_wavelength_nm, max_wavelength_nm));
        const Sought chief = chief_sines(system, reference_, object_sines);
        if (chief.fate != TraceFate::Passed) return lost(chief.fate);
        const TraceResult landed = traced_to_retina(
            system, reference_, stop_ray(system, V2d(0.0), chief.value), system.lens);
        if (landed.fate != TraceFate::Passed) return lost(landed.fate);
        const Sought stop_m = stop_point(system, reference_, to_system(pupil_point_m));
        if (stop_m.fate != TraceFate::Passed) return lost(stop_m.fate);
        const Sought sines =
            sines_to_retina(system, indices, stop_m.value, landed.ray.origin_m, chief.value);
        if (sines.fate != TraceFate::Passed) return lost(sines.fate);
        return leaving(indices, stop_m.value, sines.value);
    }

    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override
    {
        return body_.retinal_conjugate_d;
    }

    [[nodiscard]] double pupil_diameter_m() const override { return pupil_diameter_m_; }

    [[nodiscard]] double fit_residual_arcmin() const override { return 0.0; }

private:
    EyeRay leaving(const Indices& indices, const V2d& stop_point_m, const V2d& sines) const
    {
        const TraceResult traced = object_ray(body_.system, indices, stop_point_m, sines);
        if (traced.fate != TraceFate::Passed) return lost(traced.fate);
        // A ray that leaves at more than 90 degrees from the axis has no slope.
        constexpr double least_forward = 1e-6;
        if (!(traced.ray.direction.z < -least_forward)) return lost(TraceFate::Missed);
        const OpticalRay ray = at_plane(traced.ray, body_.entrance_pupil_m);
        const V2d origin_m = to_camera({ray.origin_m.x, ray.origin_m.y});
        return {.origin_eye_m = {origin_m.x, origin_m.y, 0.0},
                .slope = to_camera(V2d(ray.direction.x, ray.direction.y) / -ray.direction.z)};
    }

    V2d to_system(const V2d& p) const
    {
        return {body_.axis_x_camera.dot(p), body_.axis_x_camera.cross(p)};
    }

    V2d to_camera(const V2d& p) const
    {
        const V2d& x = body_.axis_x_camera;
        return {x.x * p.x - x.y * p.y, x.y * p.x + x.x * p.y};
    }

    SchematicBody body_;
    Indices reference_;
    double pupil_diameter_m_;
};

}  // namespace

std::string_view to_string(RefractionZero zero)
{
    switch (zero) {
    case RefractionZero::Paraxial: return "paraxial";
    case RefractionZero::MinimumRmsSpot: return "minimum_rms_spot";
    }
    return "";
}

std::unique_ptr<SchematicEye> make_schematic_eye(const SchematicSpec& spec)
{
    return std::make_unique<TracedEye>(schematic_body(spec), spec.pupil_diameter_m);
}

}  // namespace eye_render
