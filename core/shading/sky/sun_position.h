// The sun's place in the sky from two angles of any size.

#pragma once

#include "base/units.h"
#include "base/vector.h"

#include <cmath>

namespace eye_render {

struct SunPosition {
    double elevation_rad;  // -pi/2 to pi/2
    double rotation_rad;   // clockwise seen from above, from +Y
};

// Beyond the zenith the sun comes down on the other side.
[[nodiscard]] inline SunPosition sun_position(double elevation_rad, double rotation_rad)
{
    const double elevation = std::remainder(elevation_rad, 2.0 * pi);
    if (std::abs(elevation) <= 0.5 * pi) {
        return {elevation, rotation_rad};
    }
    return {std::copysign(pi, elevation) - elevation, rotation_rad + pi};
}

// Unit, +Z up; `azimuth_rad` counterclockwise seen from above, from +X.
[[nodiscard]] inline V3d direction_at(double elevation_rad, double azimuth_rad)
{
    return {std::cos(elevation_rad) * std::cos(azimuth_rad),
            std::cos(elevation_rad) * std::sin(azimuth_rad), std::sin(elevation_rad)};
}

}  // namespace eye_render
