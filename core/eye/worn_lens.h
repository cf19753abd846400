// The lens that a person wears: glasses or a contact lens, right for their eye or not.

#pragma once

#include "base/vector.h"
#include "optics/prescription.h"

namespace eye_render {

// The entrance pupil behind the cornea: 3.04 mm in the schematic eyes of Le Grand and Navarro.
inline constexpr double cornea_to_entrance_pupil_m = 3.05e-3;

inline constexpr double max_vertex_m = 20e-3;

struct WornLens {
    PowerMatrix power_d;      // where the lens is, camera frame
    double distance_m = 0.0;  // before the entrance pupil
    V2d prism_slope{0.0};     // by which it bends the line of sight
};

// Glasses made to a prescription, `vertex_m` before the cornea. Both throw std::invalid_argument
// for numbers out of range.
[[nodiscard]] WornLens glasses(const Prescription& rx, double vertex_m);

// A contact lens; its prescription is written for the cornea.
[[nodiscard]] WornLens contact_lens(const Prescription& rx);

}  // namespace eye_render
