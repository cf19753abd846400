// The sky of Hosek & Wilkie 2012, "An Analytic Model for Full Spectral Sky-Dome Radiance", eq. 8,
// in CIE XYZ. Directions are towards the sky, +Z up.

#pragma once

#include "base/working_space.h"
#include "shading/sky/hosek_wilkie_data.h"

namespace eye_render {

class HosekWilkieSky {
public:
    // `sun` need not be unit; below the horizon it stands on it. Turbidity from 1 to 10, the
    // ground's albedo from 0 to 1.
    HosekWilkieSky(const V3f& sun, float turbidity, float ground_albedo, WorkingSpace space);

    [[nodiscard]] Color3f radiance(const V3f& direction) const;

private:
    struct Channel {
        std::array<float, HosekWilkieData::shape_parameters> shape;
        float mean = 0.0f;
    };

    WorkingSpace space_;
    V3f sun_;  // unit
    std::array<Channel, 3> xyz_;
};

}  // namespace eye_render
