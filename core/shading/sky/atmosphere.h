// Sunlight scattered once in the Earth's air, spectrally: Nishita, Sirai, Tadamura & Nakamae 1993,
// "Display of the Earth Taking into Account Atmospheric Scattering", with ozone as in Blender's
// sky texture. Metres from the Earth's centre, whose +Z goes through the observer's zenith.

#pragma once

#include "base/vector.h"

namespace eye_render {

// Densities relative to a clear sky's.
struct Atmosphere {
    double air = 1.0;
    double dust = 1.0;
    double ozone = 1.0;
};

class Air {
public:
    Air(const Atmosphere& atmosphere, double altitude_m);

    // Light from a direction of the sky, XYZ in W/(m^2 sr) summed over nm. Directions are unit.
    [[nodiscard]] V3d scattered_xyz(const V3d& direction, const V3d& sun) const;

    // The same of what is left of the sun's own light, coming from `direction` alone: irradiance,
    // per m^2. Ozone takes no part, as in Blender.
    [[nodiscard]] V3d sunlight_xyz(const V3d& direction) const;

private:
    Atmosphere atmosphere_;
    V3d observer_m_;
};

}  // namespace eye_render
