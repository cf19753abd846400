// Rays through a given point of the stop: the searches that an exact trace consists of.
//
// Frame of the lens system (principal meridians of the cornea, z inwards). The direction of a ray
// is given by its sines, the x and y of the unit vector that points towards the retina.

#pragma once

#include "optics/lens_system.h"

namespace eye_render {

// A point or a pair of sines that was looked for; without meaning unless it passed.
struct Sought {
    TraceFate fate = TraceFate::Passed;
    V2d value{0.0};
};

// The ray with these sines through a point of the stop's plane.
[[nodiscard]] OpticalRay stop_ray(const LensSystem& system,
                                  const V2d& stop_point_m,
                                  const V2d& sines);

// The point of the stop that a ray parallel to the axis reaches from `pupil_point_m`, a point of
// the entrance pupil as it is seen from far away.
[[nodiscard]] Sought stop_point(const LensSystem& system,
                                const Indices& indices,
                                const V2d& pupil_point_m);

// The sines at the stop's centre of the ray that comes in from the scene with `object_sines`.
[[nodiscard]] Sought chief_sines(const LensSystem& system,
                                 const Indices& indices,
                                 const V2d& object_sines);

// The sines at a point of the stop of the ray that reaches `retina_point_m`. `chief` are the sines
// at the stop's centre of the reference ray to that point, from where the search starts.
[[nodiscard]] Sought sines_to_retina(const LensSystem& system,
                                     const Indices& indices,
                                     const V2d& stop_point_m,
                                     const V3d& retina_point_m,
                                     const V2d& chief);

// The ray in the scene, with its origin on the cornea, that reaches a point of the stop with
// `sines`; it points away from the eye.
[[nodiscard]] TraceResult object_ray(const LensSystem& system,
                                     const Indices& indices,
                                     const V2d& stop_point_m,
                                     const V2d& sines);

}  // namespace eye_render
