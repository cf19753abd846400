// Rays by an exact trace, or with fitted maps in place of its searches.
//
// What makes an exact ray slow is looking for it: for the chief ray of a direction, and for the
// ray from a point of the stop to a point of the retina. Both answers are smooth, so they are
// fitted once for an eye. The cornea is never fitted: every ray is refracted at its two surfaces
// as it leaves. An eye is fitted over the widest field in which no ray is lost and all are right;
// beyond it, and beyond its pupil, rays are traced exactly.

#include "eye/schematic.h"

#include "base/sobol.h"
#include "base/units.h"
#include "eye/aim_map.h"
#include "eye/schematic_body.h"
#include "eye/schematic_rays.h"
#include "eye/symmetric_map.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

constexpr std::array fitted_fields_deg{40.0, 30.0, 20.0, 10.0};

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

struct FittedMaps {
    SymmetricMap chief;  // object sines to sines at the stop's centre
    SymmetricMap stop;   // entrance pupil to stop, metres
    AimMap aim;
    double max_object_sine = 0.0;
    double max_pupil_radius_m = 0.0;
};

std::optional<FittedMaps> fitted_maps(const LensSystem& system,
                                      double pupil_radius_m,
                                      double field_deg)
{
    // Maps of a point have no scale: a closed pupil is fitted as one of 0.1 mm.
    constexpr double narrowest_m = 0.1e-3;
    const Indices indices = indices_at(system, reference_wavelength_nm);
    const double radius_m = std::max(pupil_radius_m, narrowest_m);
    const double max_object_sine = std::sin(rad_from_deg(field_deg));
    const auto chief = SymmetricMap::fitted(
        [&](const V2d& object_sines) { return chief_sines(system, indices, object_sines); },
        max_object_sine);
    const auto stop = SymmetricMap::fitted(
        [&](const V2d& pupil_m) { return stop_point(system, indices, pupil_m); }, radius_m);
    if (!chief || !stop) return std::nullopt;
    // Largest in one of the principal meridians.
    const auto max_length = [](const SymmetricMap& map, double radius) {
        return std::max(map({radius, 0.0}).length(), map({0.0, radius}).length());
    };
    const auto aim =
        AimMap::fitted(system, max_length(*stop, radius_m), max_length(*chief, max_object_sine));
    if (!aim) return std::nullopt;
    return FittedMaps{*chief, *stop, *aim, max_object_sine, radius_m};
}

class SurfaceEye final : public EyeModel {
public:
    SurfaceEye(const SchematicBody& body, const SchematicSpec& spec)
        : body_(body), reference_(indices_at(body.system, reference_wavelength_nm)),
          pupil_diameter_m_(spec.pupil_diameter_m)
    {
        if (spec.exact_trace) return;
        for (const double field_deg : fitted_fields_deg) {
            maps_ = fitted_maps(body_.system, 0.5 * pupil_diameter_m_, field_deg);
            if (!maps_) continue;
            fit_error_arcmin_ = largest_fit_error_arcmin();
            if (fit_error_arcmin_ <= max_fit_error_arcmin) {
                fitted_field_deg_ = field_deg;
                return;
            }
        }
        maps_.reset();
        fit_error_arcmin_ = 0.0;
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double wavelength_nm) const override
    {
        const V2d object_sines =
            -to_system(chief_slope) / std::hypot(1.0, chief_slope.x, chief_slope.y);
        const V2d pupil_m = to_system(pupil_point_m);
        const double nm = std::clamp(wavelength_nm, min_wavelength_nm, max_wavelength_nm);
        const bool is_fitted = maps_ && object_sines.length() <= maps_->max_object_sine &&
                               pupil_m.length() <= maps_->max_pupil_radius_m;
        return is_fitted ? fitted_ray(object_sines, pupil_m, nm)
                         : exact_ray(object_sines, pupil_m, nm);
    }

    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override
    {
        return body_.retinal_conjugate_d;
    }

    [[nodiscard]] double pupil_diameter_m() const override { return pupil_diameter_m_; }

    [[nodiscard]] double max_accommodation_d() const override { return body_.max_accommodation_d; }

    [[nodiscard]] double approximation_arcmin() const override { return fit_error_arcmin_; }

    [[nodiscard]] std::optional<double> fitted_field_deg() const override
    {
        return fitted_field_deg_;
    }

    [[nodiscard]] bool is_first_order() const override { return false; }

private:
    [[nodiscard]] EyeRay exact_ray(const V2d& object_sines,
                                   const V2d& pupil_m,
                                   double wavelength_nm) const
    {
        const LensSystem& system = body_.system;
        const Sought chief = chief_sines(system, reference_, object_sines);
        if (chief.fate != TraceFate::Passed) return lost(chief.fate);
        const TraceResult landed = traced_to_retina(
            system, reference_, stop_ray(system, V2d(0.0), chief.value), system.lens);
        if (landed.fate != TraceFate::Passed) return lost(landed.fate);
        const Sought stop_m = stop_point(system, reference_, pupil_m);
        if (stop_m.fate != TraceFate::Passed) return lost(stop_m.fate);
        const Indices indices = indices_at(system, wavelength_nm);
        const Sought sines =
            sines_to_retina(system, indices, stop_m.value, landed.ray.origin_m, chief.value);
        if (sines.fate != TraceFate::Passed) return lost(sines.fate);
        return leaving(indices, stop_m.value, sines.value);
    }

    [[nodiscard]] EyeRay fitted_ray(const V2d& object_sines,
                                    const V2d& pupil_m,
                                    double wavelength_nm) const
    {
        const V2d stop_m = maps_->stop(pupil_m);
        const V2d sines = maps_->aim(stop_m, maps_->chief(object_sines), wavelength_nm);
        return leaving(wavelength_nm == reference_wavelength_nm
                           ? reference_
                           : indices_at(body_.system, wavelength_nm),
                       stop_m, sines);
    }

    [[nodiscard]] EyeRay leaving(const Indices& indices,
                                 const V2d& stop_point_m,
                                 const V2d& sines) const
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

    // Over the fitted field and pupil, about a quarter of the rays on either rim, and the visible
    // wavelengths. Infinite when a ray has another fate.
    [[nodiscard]] double largest_fit_error_arcmin() const
    {
        constexpr std::uint32_t rays = 2048;
        constexpr double beyond_rim = 1.15;
        const auto in_disk = [](float u_radius, float u_angle) {
            return unit(2.0 * pi * u_angle) * std::min(1.0, beyond_rim * std::sqrt(u_radius));
        };
        const std::uint64_t key = sobol_key(0, 0);
        double largest_rad = 0.0;
        for (std::uint32_t i = 0; i < rays; ++i) {
            const auto u = sobol_4d(key, i, 0);
            const V2d object_sines = in_disk(u[0], u[1]) * maps_->max_object_sine;
            const V2d pupil_m = in_disk(u[2], u[3]) * (0.5 * pupil_diameter_m_);
            const double nm =
                std::lerp(min_wavelength_nm, max_wavelength_nm, double(sobol_4d(key, i, 1)[0]));
            const EyeRay exact = exact_ray(object_sines, pupil_m, nm);
            const EyeRay fitted = fitted_ray(object_sines, pupil_m, nm);
            if (exact.fate != fitted.fate) return std::numeric_limits<double>::infinity();
            largest_rad = std::max(largest_rad, angle_rad(exact.slope, fitted.slope));
        }
        return arcmin_from_rad(largest_rad);
    }

    static V2d unit(double angle_rad) { return {std::cos(angle_rad), std::sin(angle_rad)}; }

    static double angle_rad(const V2d& slope_a, const V2d& slope_b)
    {
        const V3d a = V3d(slope_a.x, slope_a.y, 1.0).normalized();
        const V3d b = V3d(slope_b.x, slope_b.y, 1.0).normalized();
        return a.cross(b).length();
    }

    [[nodiscard]] V2d to_system(const V2d& p) const
    {
        return {body_.axis_x_camera.dot(p), body_.axis_x_camera.cross(p)};
    }

    [[nodiscard]] V2d to_camera(const V2d& p) const
    {
        const V2d& x = body_.axis_x_camera;
        return {x.x * p.x - x.y * p.y, x.y * p.x + x.x * p.y};
    }

    SchematicBody body_;
    Indices reference_;
    double pupil_diameter_m_;
    std::optional<FittedMaps> maps_{};
    double fit_error_arcmin_ = 0.0;
    std::optional<double> fitted_field_deg_{};
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

std::unique_ptr<EyeModel> make_schematic_eye(const SchematicSpec& spec)
{
    return std::make_unique<SurfaceEye>(schematic_body(spec), spec);
}

}  // namespace eye_render
