// Shadow catchers: surfaces of which only the shadows, reflections and light that objects bring
// are in the picture, for laying it over a photograph of the place. As Cycles composes them.
//
// Where the camera sees a catcher, the path goes on as if the catcher were any surface, and a
// second one as if there were nothing but catchers: the ratio of their light is what objects do.

#pragma once

#include "base/vector.h"

#include <array>

namespace eye_render {

// Means of one pixel.
struct CaughtLight {
    V3d all{0.0};     // the picture with catchers as any surface
    V3d matte{0.0};   // of it, what no catcher caught first
    V3d bare{0.0};    // on the catchers, as if there were nothing else
    V3d behind{0.0};  // of the world behind the catchers
    double alpha = 1.0;
    double matte_alpha = 1.0;
};

// What the light on the place must be multiplied by; 1 where no catcher is.
[[nodiscard]] V3d catcher_factor(const CaughtLight& light);

// Without the shadow: for those who multiply by the factor themselves.
[[nodiscard]] std::array<double, 4> without_shadow(const CaughtLight& light);
// The shadow as black that covers a transparent film, or that darkens the world behind.
[[nodiscard]] std::array<double, 4> over_nothing(const CaughtLight& light);
[[nodiscard]] std::array<double, 4> over_world(const CaughtLight& light);

}  // namespace eye_render
