// How droplets of water scatter, by their size: the fit to Mie's theory of Jendersie and d'Eon
// 2023, "An Approximate Mie Scattering Function for Fog and Cloud Rendering".

#pragma once

#include "shading/phase_function.h"

namespace eye_render {

struct DropletScattering {
    PhaseFunction narrow;     // Henyey and Greenstein's
    PhaseFunction wide;       // Draine's
    float wide_share = 0.0f;  // of the light
};

// Diameters above 50 um, where the fit ends, count as that; the smallest scatter as Rayleigh's.
[[nodiscard]] DropletScattering scattering_of_droplets(float diameter_um);

}  // namespace eye_render
