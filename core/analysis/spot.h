// The spot of a point as an eye model sees it, by sampling the pupil: for any model, and the check
// that a model agrees with its closed form.

#pragma once

#include "eye/eye_model.h"

#include <cstdint>

namespace eye_render {

// Moments of the directions, in radians (slopes) and radians squared, relative to the chief slope.
struct SpotMoments {
    V2d mean{0.0};
    double xx = 0.0;  // central second moments
    double xy = 0.0;
    double yy = 0.0;
    double transmitted = 0.0;  // the mean weight, 0 to 1
};

struct SpotOptions {
    V2d chief_slope{0.0};
    double object_vergence_d = 0.0;  // 1/distance along the axis; 0 at infinity
    double wavelength_nm = 555.0;
    std::uint32_t samples = 65536;
};

// Evenly filled pupil. All moments are 0 when nothing is transmitted.
[[nodiscard]] SpotMoments spot_moments(const EyeModel& eye, const SpotOptions& options = {});

}  // namespace eye_render
