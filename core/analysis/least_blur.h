// How an eye with aberrations accommodates: for the least blur through its whole pupil, which is
// not where rays next to the axis come to a focus.

#pragma once

#include "eye/eye_model.h"

#include <functional>
#include <memory>

namespace eye_render {

// The eye at an accommodation in dioptres. May throw std::invalid_argument where it has none.
using EyeAtAccommodation = std::function<std::unique_ptr<EyeModel>(double)>;

// The accommodation, 0 to `amplitude_d`, at which the RMS radius of the spot of a point on the
// axis, at 555 nm, is least: to about 0.02 D. Takes some 20 eyes and 8000 rays, so the eyes had
// better not be fitted first.
[[nodiscard]] double least_blur_accommodation_d(const EyeAtAccommodation& eye_at,
                                                double object_vergence_d,
                                                double amplitude_d);

}  // namespace eye_render
