// Reflectance of a boundary under a film about as thick as light's wavelength: Belcour & Barla
// 2017, "A Practical Extension to Microfacet Theory for the Modeling of Varying Iridescence".
// A spectrum that is even is white; indices are over that of the near side.

#pragma once

#include "base/working_space.h"

namespace eye_render {

// Films that are thinner count as none.
inline constexpr float thinnest_film_nm = 0.1f;

// White where light does not get through. `cos_incident` in [0, 1].
[[nodiscard]] Color3f film_reflectance(float cos_incident,
                                       float film_thickness_nm,
                                       float film_ior,
                                       float base_ior,
                                       WorkingSpace space);

// The same where the boundary is tinted to reflect `f0` at normal incidence without the film.
[[nodiscard]] Color3f tinted_film_reflectance(float cos_incident,
                                              float film_thickness_nm,
                                              float film_ior,
                                              float base_ior,
                                              const Color3f& f0,
                                              WorkingSpace space);

}  // namespace eye_render
