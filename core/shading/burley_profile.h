// How far from where it entered light leaves a flat surface: Christensen & Burley 2015,
// "Approximate Reflectance Profiles for Efficient Subsurface Scattering", eq. 3, cut off where
// next to nothing is left. `scale` is the profile's d; distances are in its unit.

#pragma once

namespace eye_render {

// Of the distance, by the scale.
inline constexpr float burley_cutoff = 16.0f;

// Density per unit distance: 1 up to the cutoff.
[[nodiscard]] float burley_pdf(float scale, float distance);

// u in [0, 1).
[[nodiscard]] float sample_burley_distance(float scale, float u);

}  // namespace eye_render
