// The lobes of rough boundaries as materials ask for them: from roughness and colour, with the
// light that single scattering loses given back or not (energy_tables.h). Each call adds one lobe
// to a mixture.

#pragma once

#include "shading/bsdf.h"

namespace eye_render {

// The rough boundary all lobes of one material share. `normal` is towards the viewer.
struct GgxSurface {
    V3f normal;
    float cos_o;      // between normal and wo
    float roughness;  // Blender's: alpha is its square
    bool multiple_scattering;
    FacetModel facets = FacetModel::Ggx;  // only GGX is compensated
    // Factors on alpha along `tangent`, unit and across the normal, and across it: for reflection.
    float stretch_x = 1.0f;
    float stretch_y = 1.0f;
    V3f tangent{0.0f};
};

// Brushes the surface along `tangent`, of any length, turned around `axis`. Without a tangent any
// direction serves.
void brush(GgxSurface& surface,
           float stretch_x,
           float stretch_y,
           const V3f& tangent,
           float rotation_turns,
           const V3f& axis);

// A boundary between two media that are clear.
struct Boundary {
    float ior;                                       // of the far side over the viewer's
    Color3f specular_tint{1.0f};                     // of what is reflected at normal incidence
    float film_thickness_nm = 0.0f;                  // of a film on it; 0 for none
    float film_ior = 1.0f;                           // over the viewer's side
    WorkingSpace film_space = WorkingSpace::Rec709;  // of all colours
};

// A mirror of this colour at every angle.
void add_glossy(Bsdf& bsdf, const GgxSurface& surface, float weight, const Color3f& color);

// The same by Ashikhmin & Shirley's lobe, which is not compensated.
void add_phong(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color);

// `f0` is the colour at normal incidence, in [0, 1]; it is white at grazing incidence, and
// `edge_tint` times as bright near 82 degrees.
void add_metal(Bsdf& bsdf,
               const GgxSurface& surface,
               const Color3f& weight,
               const Color3f& f0,
               const Color3f& edge_tint);

// A metal by its index and extinction.
void add_conductor(Bsdf& bsdf,
                   const GgxSurface& surface,
                   float weight,
                   const Color3f& index,
                   const Color3f& extinction);

// The reflection of the polish on a diffuse base. Returns the fraction of light, of `weight` and
// in the colour of most, that it keeps from what lies below.
[[nodiscard]] float add_dielectric(Bsdf& bsdf,
                                   const GgxSurface& surface,
                                   const Color3f& weight,
                                   const Boundary& boundary);

// The reflection of a clear coat: never compensated, and as smooth to what lies below. Returns as
// add_dielectric.
[[nodiscard]] float add_coat(Bsdf& bsdf,
                             const GgxSurface& surface,
                             const Color3f& weight,
                             float ior);

// The colours of what is reflected and of what passes.
void add_glass(Bsdf& bsdf,
               const GgxSurface& surface,
               const Color3f& weight,
               const Color3f& reflection,
               const Color3f& transmission,
               const Boundary& boundary);

// Glass that reflects nothing but what it reflects totally, and that is black.
void add_refraction(Bsdf& bsdf, const GgxSurface& surface, const Color3f& color, float ior);

}  // namespace eye_render
