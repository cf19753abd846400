// Where an eye focuses, from its rays: what they see sharpest, and its two focal lines.

#pragma once

#include "analysis/pupil_trace.h"

#include <optional>

namespace eye_render {

// In object space, so for an eye behind a lens with that lens.
struct ThroughFocus {
    // The vergence of the plane where the rays' RMS distance from their centroid, as an angle, is
    // least: for an eye with astigmatism, its circle of least confusion. Nothing for an eye
    // without a pupil's width, which focuses nowhere.
    std::optional<double> best_focus_d;
    // The matrix K that comes closest, in the least squares, to leading every ray to one point:
    // its eigenvalues are the vergences of the focal lines.
    PowerMatrix conjugate_d;
};

[[nodiscard]] ThroughFocus through_focus(const PupilTrace& trace);

// On the axis at 555 nm.
[[nodiscard]] ThroughFocus through_focus(const EyeModel& eye);

}  // namespace eye_render
