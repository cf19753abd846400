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

// Of a place that was hit, in the picture at that time.
std::optional<V2d> raster_at(const ChiefRays& rays, const SurfaceHit& hit, float time)
{
    const V3d p_world = rays.frame.position_world + V3d(rays.scene.place_at(hit, time));
    const bool is_still = rays.camera_motion == nullptr || time == shutter_middle;
    return raster_of(is_still ? rays.frame : rays.camera_motion->at(time), rays.eye, p_world);
}

// As Pass::Vector has it; zero where the place is not to be seen at one of the times.
std::array<double, 4> motion_vectors_px(const ChiefRays& rays, const SurfaceHit& hit)
{
    const auto before = raster_at(rays, hit, 0.0f);
    const auto now = raster_at(rays, hit, shutter_middle);
    const auto after = raster_at(rays, hit, 1.0f);
    if (!(before && now && after)) {
        return {};
    }
    return {before->x - now->x, before->y - now->y, now->x - after->x, now->y - after->y};
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
    if (layout.has(Pass::Vector)) {
        const auto vectors = motion_vectors_px(rays, surface);
        std::ranges::transform(vectors, values.begin() + layout.first(Pass::Vector),
                               [](double value) { return static_cast<float>(value); });
    }
    set(Pass::ObjectIndex, {surface.placement->look.pass_index});
    set(Pass::MaterialIndex, {static_cast<double>(surface.material().pass_index)});
}

double distance_along_m(const ChiefRays& rays, const V2d& chief_slope)
{
    return chief_hit(rays, chief_slope).depth * rays.frame.metres_per_unit;
}

}  // namespace eye_render
