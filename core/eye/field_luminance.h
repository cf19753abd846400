// The luminance that the eye adapts to, from a picture of what it sees, and the field's extent.
//
// Wang & Xiao 2013 eq. 14 to 18: pixels are weighted by exp(-(a^2 + b^2) / 2 sigma^2), with a and
// b running from -1 to 1 across the picture, because the pupil heeds the centre of the gaze.

#pragma once

#include "base/working_space.h"

#include <cstddef>
#include <span>

namespace eye_render {

// Of the channels: eq. 14.
inline const V3d paper_luminance_weights{0.3, 0.59, 0.11};

struct FieldLuminanceOptions {
    V3d weights{luminance_weights(WorkingSpace::Rec709)};  // of the channels
    double sigma = 0.5;             // in half pictures; not printed in the paper
    double cd_m2_per_unit = 179.0;  // of a white pixel of value 1
};

// Weighted mean luminance in cd/m^2 of `pixels`, scene-linear, row by row, `width` a row. Pixels
// that are not finite do not count; 0 when none does. Throws std::invalid_argument when there are
// no pixels, when rows are incomplete, and for a sigma or scale that is not above 0.
[[nodiscard]] double field_luminance_cd_m2(std::span<const Color3f> pixels,
                                           std::size_t width,
                                           const FieldLuminanceOptions& options = {});

// A rectangle of the plane at distance 1 before the eye, in slopes.
struct SlopeWindow {
    double left = -1.0;
    double right = 1.0;
    double bottom = -1.0;
    double top = 1.0;
};

// The window's solid angle in square degrees.
[[nodiscard]] double field_area_deg2(const SlopeWindow& window);

}  // namespace eye_render
