// What an eye can see sharply, from its far point to its near point, and in which meridians.

#pragma once

#include "optics/power_matrix.h"

#include <optional>
#include <vector>

namespace eye_render {

// From the relaxed eye's conjugate to the accommodated one's. Vergences: positive before the eye,
// 0 at infinity, negative behind it.
struct ClearRange {
    // The pupil's meridian whose light is focused, counter-clockwise from +X as the patient sees,
    // 0 to below 180; nothing for the mean of all.
    std::optional<double> meridian_deg{};
    double far_d = 0.0;
    double near_d = 0.0;
};

// The mean first; then, for a toric eye, its two principal meridians, the one that sees farther
// first. The arguments are the conjugates of an eye (ThroughFocus) at rest and at its full
// accommodation.
[[nodiscard]] std::vector<ClearRange> clear_ranges(const PowerMatrix& relaxed_d,
                                                   const PowerMatrix& accommodated_d);

}  // namespace eye_render
