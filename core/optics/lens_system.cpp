#include "optics/lens_system.h"

#include <cmath>

namespace eye_render {

namespace {

// Refracts `ray` at one surface. A hit that lies behind the ray's origin belongs to surfaces that
// cross beyond the edge of the lens or of the anterior chamber; no light takes that way. The
// rounding of a ray that starts on the surface is allowed for.
TraceFate refract_at(const OpticalSurface& surface, double index_ratio, OpticalRay& ray)
{
    constexpr double rounding_m = 1e-12;
    const auto hit_m = surface.shape.intersection(ray);
    if (!hit_m || !surface.shape.is_on_vertex_side(*hit_m)) return TraceFate::Missed;
    if ((*hit_m - ray.origin_m).dot(ray.direction) < -rounding_m) return TraceFate::Missed;
    if (std::hypot(hit_m->x, hit_m->y) > surface.semi_aperture_m) return TraceFate::Vignetted;
    const auto direction = refracted(ray.direction, surface.shape.normal(*hit_m), index_ratio);
    if (!direction) return TraceFate::TotalReflection;
    ray = {*hit_m, *direction};
    return TraceFate::Passed;
}

}  // namespace

Indices indices_at(const LensSystem& system, double wavelength_nm)
{
    Indices indices{};
    indices[0] = 1.0;
    for (std::size_t i = 0; i < system.surfaces.size(); ++i) {
        indices[i + 1] = refractive_index(system.surfaces[i].behind, wavelength_nm);
    }
    return indices;
}

TraceResult traced_inward(const LensSystem& system,
                          const Indices& indices,
                          const OpticalRay& ray,
                          std::size_t first,
                          std::size_t last)
{
    TraceResult traced{.ray = ray};
    for (std::size_t i = first; i < last && traced.fate == TraceFate::Passed; ++i) {
        traced.fate = refract_at(system.surfaces[i], indices[i] / indices[i + 1], traced.ray);
    }
    return traced;
}

TraceResult traced_outward(const LensSystem& system,
                           const Indices& indices,
                           const OpticalRay& ray,
                           std::size_t first,
                           std::size_t last)
{
    TraceResult traced{.ray = ray};
    for (std::size_t i = last; i > first && traced.fate == TraceFate::Passed; --i) {
        traced.fate = refract_at(system.surfaces[i - 1], indices[i] / indices[i - 1], traced.ray);
    }
    return traced;
}

TraceResult traced_to_retina(const LensSystem& system,
                             const Indices& indices,
                             const OpticalRay& ray,
                             std::size_t first)
{
    TraceResult traced = traced_inward(system, indices, ray, first, system.surfaces.size());
    if (traced.fate != TraceFate::Passed) return traced;
    const auto hit_m = system.retina.intersection(traced.ray);
    if (!hit_m || (*hit_m - traced.ray.origin_m).dot(traced.ray.direction) < 0.0) {
        traced.fate = TraceFate::Missed;
        return traced;
    }
    traced.ray.origin_m = *hit_m;
    return traced;
}

OpticalRay at_plane(const OpticalRay& ray, double z_m)
{
    return {ray.origin_m + ray.direction * ((z_m - ray.origin_m.z) / ray.direction.z),
            ray.direction};
}

}  // namespace eye_render
