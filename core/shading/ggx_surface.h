// The GGX lobes as materials ask for them: from roughness and colour, with the light that single
// scattering loses given back or not (energy_tables.h). Each call adds one lobe to a mixture.

#pragma once

#include "shading/bsdf.h"

namespace eye_render {

// The rough boundary all lobes of one material share. `normal` is towards the viewer.
struct GgxSurface {
    V3f normal;
    float cos_o;      // between normal and wo
    float roughness;  // Blender's: alpha is its square
    bool multiple_scattering;
};

// A mirror of this colour at every angle.
void add_glossy(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color, float weight = 1.0f);

// `f0` is the colour at normal incidence, in [0, 1]; it is white at grazing incidence.
void add_metal(Bsdf& bsdf, const GgxSurface& surface, float weight, const Color3f& f0);

// The reflection of a clear coat or of the polish on a diffuse base. Returns the fraction of
// light, of `weight`, that it keeps from what lies below.
[[nodiscard]] float add_dielectric(Bsdf& bsdf, const GgxSurface& surface, float weight, float ior);

// The colours of what is reflected and of what passes. `ior` is of the far side over the viewer's.
void add_glass(Bsdf& bsdf,
               const GgxSurface& surface,
               float weight,
               const Color3f& reflection,
               const Color3f& transmission,
               float ior);

}  // namespace eye_render
