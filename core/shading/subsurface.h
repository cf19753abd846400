// Light that enters a surface, is scattered below it and leaves it elsewhere: a closure given by
// the colour that comes out and by how far light goes, as Cycles understands the two.
//
// The colour becomes the albedo of a single scattering so that a half space of the medium, lit
// evenly, has that colour. RandomWalk inverts van de Hulst's reflectance of a half space: Kulla &
// Conty 2017, "Revisiting Physically Based Shading at Imageworks". The other walks are older:
// Chiang, Kutz & Burley 2016, "Practical and Controllable Subsurface Scattering for Production
// Path Tracing", with the fit for anisotropic media of Wrenninge, Villemin & Hery 2017, "Path
// Traced Subsurface Scattering using Anisotropic Phase Functions and Non-Exponential Free
// Flights". Lengths are in units of the scene.

#pragma once

#include "shading/bsdf.h"

#include <numbers>

namespace eye_render {

struct ShadingPoint;

struct SubsurfaceInputs {
    LobeKind method = LobeKind::RandomWalk;  // of those that are subsurface
    Color3f color{0.8f};                     // in [0, 1]
    Color3f radius{1.0f};                    // how far light of each channel goes
    float alpha = 1.0f;                      // of the facets that light enters through
    float ior = 1.4f;                        // of the inside
    float anisotropy = 0.0f;
    // From Blender 5.2. Burley's light still stays where it is after a diffuse bounce.
    bool always_walks = false;
};

// Adds the closure. `weight` includes the colour; values out of range are brought into it. A
// channel that goes less far than a picture could tell, and all of them after a diffuse bounce, is
// a Lambert lobe instead, unless light always walks.
void add_subsurface(Bsdf& bsdf,
                    const SubsurfaceInputs& inputs,
                    const Color3f& weight,
                    const V3f& normal,
                    const ShadingPoint& point,
                    bool after_diffuse);

// Lobes that `add_subsurface` adds at most.
inline constexpr int subsurface_lobes = 2;

// The albedo of one scattering that gives a half space the colour, both in [0, 1].
[[nodiscard]] float single_scattering_albedo(float color, float anisotropy);

// The same by the fit, for an anisotropy in [0, 0.9].
[[nodiscard]] float legacy_single_scattering_albedo(float color, float anisotropy);

// What light meets below a surface.
struct SubsurfaceMedium {
    Color3f extinction{0.0f};  // per unit length
    Color3f albedo{0.0f};      // of a single scattering; at least least_walk_albedo
    float anisotropy = 0.0f;
    // What light counts that enters by the lobe's weight: the colour comes of the medium instead.
    Color3f entering{0.0f};
};

// Less is scattered as this, and less of it enters: walks end by then anyway, and the directions
// that lead them out would be a single one.
inline constexpr float least_walk_albedo = 0.2f;

// Of RandomWalk, Blender's radius is the mean free path. In its older methods it counts as
// several: so that a walk looks like diffusion.
inline constexpr float mean_free_path_of_radius = 0.25f * std::numbers::inv_pi_v<float>;

// Of a lobe of a random walk.
[[nodiscard]] SubsurfaceMedium subsurface_medium(const Lobe& lobe);

// One whose light is scattered evenly, and as far on the whole: the similarity relation (van de
// Hulst 1980, "Multiple Light Scattering", 14.1).
[[nodiscard]] SubsurfaceMedium even_medium(const SubsurfaceMedium& medium);

// The direction in which light that is seen along `wo` goes below the surface, unit: refracted by
// rough facets; of skin, half of it is Lambert's. All of u in [0, 1).
[[nodiscard]] V3f sample_entry(const Lobe& lobe, const V3f& wo, float u_choice, const V2f& u);

}  // namespace eye_render
