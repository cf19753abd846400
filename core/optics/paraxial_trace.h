// First-order optics of an eye, meridian by meridian: 2x2 matrices on (height, index x angle).
//
// Cardinal points as in Smith & Atchison 1997, "The Eye and Visual Optical Instruments", measured
// from the vertex of the cornea towards the retina. Metres and dioptres.

#pragma once

#include "optics/lens_system.h"

namespace eye_render {

// One of the two principal meridians of the biconic surfaces.
enum class Meridian { X, Y };

// height' = a height + b angle, angle' = c height + d angle; angles times the refractive index.
struct RayMatrix {
    double a = 1.0;
    double b_m = 0.0;
    double c_per_m = 0.0;
    double d = 1.0;
};

// From the vertex plane before surface `first` to that behind surface `last` - 1.
[[nodiscard]] RayMatrix ray_matrix(const LensSystem& system,
                                   const Indices& indices,
                                   Meridian meridian,
                                   std::size_t first,
                                   std::size_t last);

// Distance along the axis; `after` follows `before`.
[[nodiscard]] RayMatrix moved_along(const RayMatrix& before, double distance_m, double index);

struct EntrancePupil {
    double position_m = 0.0;  // from the cornea
    double magnification = 1.0;
};

[[nodiscard]] EntrancePupil entrance_pupil(const LensSystem& system,
                                           const Indices& indices,
                                           Meridian meridian);

// The vergence of the retina's conjugate, in dioptres, at the plane `plane_m` behind the cornea's
// vertex, seen from the scene: positive before the eye, 0 at infinity. At plane 0 it is minus the
// refraction at the cornea.
[[nodiscard]] double conjugate_vergence_d(const LensSystem& system,
                                          const Indices& indices,
                                          Meridian meridian,
                                          double plane_m);

struct CardinalPoints {
    double power_d = 0.0;
    double principal_m = 0.0;  // H, H'
    double principal_retinal_m = 0.0;
    double nodal_m = 0.0;  // N, N'
    double nodal_retinal_m = 0.0;
    double back_vertex_focal_m = 0.0;  // from the last surface
};

[[nodiscard]] CardinalPoints cardinal_points(const LensSystem& system,
                                             const Indices& indices,
                                             Meridian meridian);

}  // namespace eye_render
