// The geometrical blur of a point and of a line, in closed form.
//
// An eye with the error matrix E = K - X I (dioptres, camera frame, X the object's vergence)
// spreads a point over the pupil's image under E: an evenly filled ellipse. All sizes are angles
// in object space.

#pragma once

#include "optics/power_matrix.h"

#include <optional>

namespace eye_render {

struct BlurEllipse {
    double major_arcmin = 0.0;  // full diameters
    double minor_arcmin = 0.0;
    // Of the major diameter, degrees counter-clockwise from +X as the patient sees it, 0 to below
    // 180; nothing when the blur is round.
    std::optional<double> angle_deg;
    double rms_radius_arcmin = 0.0;
};

[[nodiscard]] BlurEllipse blur_ellipse(const PowerMatrix& error_d, double pupil_diameter_m);

// Root mean square width of a line's spread across itself. `line_angle_deg` is the line's own
// direction, counter-clockwise from +X.
[[nodiscard]] double line_spread_rms_arcmin(const PowerMatrix& error_d,
                                            double pupil_diameter_m,
                                            double line_angle_deg);

}  // namespace eye_render
