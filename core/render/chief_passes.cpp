#include "render/chief_passes.h"

#include "base/units.h"

#include <algorithm>
#include <limits>

namespace eye_render {

namespace {

struct ChiefHit {
    std::optional<SurfaceHit> surface;
    double depth = std::numeric_limits<double>::infinity();  // along the viewing axis, scene units
};

ChiefHit chief_hit(const ChiefRays& rays, const V2d& chief_slope)
{
    ChiefHit hit;
    const CameraRay chief = camera_ray(rays.frame, rays.eye, chief_slope, V2d(0.0));
    if (chief.fate == RayFate::Transmitted) {
        hit.surface = rays.scene.first_visible(chief.ray, rays.least_alpha);
        if (hit.surface) {
            hit.depth = chief.depth(static_cast<double>(hit.surface->t));
        }
    }
    return hit;
}

}  // namespace

void trace_chief_ray(const ChiefRays& rays,
                     const V2d& raster,
                     const PassLayout& layout,
                     std::span<float> values)
{
    const auto set = [&](Pass pass, std::initializer_list<double> channels) {
        if (layout.has(pass)) {
            std::ranges::transform(channels, values.begin() + layout.first(pass),
                                   [](double value) { return static_cast<float>(value); });
        }
    };
    std::ranges::fill(values, 0.0f);
    const ChiefHit hit = chief_hit(rays, rays.frame.chief_slope(raster));
    const PowerMatrix e = rays.eye.error_d(1.0 / (hit.depth * rays.frame.metres_per_unit));
    set(Pass::Depth, {std::min(hit.depth, static_cast<double>(background_depth))});
    set(Pass::Defocus, {e.mean_d()});
    set(Pass::Blur, {arcmin_from_rad(rays.eye.pupil_diameter_m() * e.largest_magnitude_d())});
    if (!hit.surface) {
        return;
    }
    const SurfaceHit& surface = *hit.surface;
    const V3d p_world = rays.frame.position_world + V3d(surface.p_world);
    set(Pass::Position, {p_world.x, p_world.y, p_world.z});
    set(Pass::ObjectIndex, {surface.placement->look.pass_index});
    set(Pass::MaterialIndex, {static_cast<double>(surface.material().pass_index)});
}

double distance_along_m(const ChiefRays& rays, const V2d& chief_slope)
{
    return chief_hit(rays, chief_slope).depth * rays.frame.metres_per_unit;
}

}  // namespace eye_render
