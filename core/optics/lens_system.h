// An eye as surfaces, and the exact trace of a ray through it in either direction.
//
// Frame: z along the light that enters, x and y along the principal meridians of the biconic
// surfaces, whatever the origin (the published eyes have it at the vertex of the cornea). Lengths
// in metres. The stop is a plane and clips nothing: whoever traces chooses the point of the stop.

#pragma once

#include "optics/conic_surface.h"
#include "optics/medium.h"

#include <array>
#include <cstddef>
#include <limits>
#include <vector>

namespace eye_render {

inline constexpr std::size_t max_optical_surfaces = 7;

struct OpticalSurface {
    ConicSurface shape;
    Medium behind;  // the medium on its retinal side
    double semi_aperture_m = std::numeric_limits<double>::infinity();
};

struct LensSystem {
    std::vector<OpticalSurface> surfaces;  // from the cornea inwards, the first one in air
    std::size_t lens = 0;                  // the first surface behind the stop
    double stop_m = 0.0;                   // z of the stop's plane
    ConicSurface retina;
};

// The refractive indices before, between and behind the surfaces at one wavelength: that behind
// surface i at i + 1, that of air (1) at 0.
using Indices = std::array<double, max_optical_surfaces + 1>;

[[nodiscard]] Indices indices_at(const LensSystem& system, double wavelength_nm);

enum class TraceFate { Passed, Vignetted, Missed, TotalReflection };

// Where a ray leaves a run of surfaces; without meaning unless it passed.
struct TraceResult {
    TraceFate fate = TraceFate::Passed;
    OpticalRay ray;
};

// Through the surfaces [first, last) towards the retina; `ray` starts before the first one.
[[nodiscard]] TraceResult traced_inward(const LensSystem& system,
                                        const Indices& indices,
                                        const OpticalRay& ray,
                                        std::size_t first,
                                        std::size_t last);

// The same surfaces in the other order, towards the scene; `ray` starts behind the last one.
[[nodiscard]] TraceResult traced_outward(const LensSystem& system,
                                         const Indices& indices,
                                         const OpticalRay& ray,
                                         std::size_t first,
                                         std::size_t last);

// From before surface `first` to the retina, where the result's origin lies.
[[nodiscard]] TraceResult traced_to_retina(const LensSystem& system,
                                           const Indices& indices,
                                           const OpticalRay& ray,
                                           std::size_t first = 0);

// The ray, carried along its line to a plane z.
[[nodiscard]] OpticalRay at_plane(const OpticalRay& ray, double z_m);

}  // namespace eye_render
