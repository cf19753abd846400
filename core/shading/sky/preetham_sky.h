// The sky of Preetham, Shirley & Smits 1999, "A Practical Analytic Model for Daylight", appendix
// A.2. Directions are towards the sky, +Z up.

#pragma once

#include "base/working_space.h"

#include <array>

namespace eye_render {

class PreethamSky {
public:
    // `sun` need not be unit.
    PreethamSky(const V3f& sun, float turbidity, WorkingSpace space);

    [[nodiscard]] Color3f radiance(const V3f& direction) const;

private:
    // Perez' five parameters, and the value at the zenith over that of the function.
    struct Channel {
        std::array<float, 5> perez;
        float scale;
    };

    WorkingSpace space_;
    V3f sun_;
    Channel luminance_;
    Channel x_;  // chromaticity
    Channel y_;
};

}  // namespace eye_render
