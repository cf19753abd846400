// Blender's Principled BSDF, version 2 (Blender 4.3), as a function of the values of its sockets.

#pragma once

#include "shading/lobe.h"

namespace eye_render {

class Bsdf;
struct ShadingPoint;

// One field a socket, with Blender's defaults; values out of range are brought into it. A normal
// or tangent may have any length; without length it is the point's own, or no tangent.
struct PrincipledInputs {
    Color3f base_color{0.8f};
    float metallic = 0.0f;
    float roughness = 0.5f;
    float ior = 1.5f;
    float alpha = 1.0f;
    V3f normal{0.0f};
    float diffuse_roughness = 0.0f;
    float subsurface_weight = 0.0f;
    V3f subsurface_radius{1.0f, 0.2f, 0.1f};  // by colour, times the scale: world units
    float subsurface_scale = 0.05f;
    float subsurface_ior = 1.4f;  // of skin; otherwise the surface's own
    float subsurface_anisotropy = 0.0f;
    float specular_ior_level = 0.5f;  // 0.5 leaves the reflectance that `ior` gives
    Color3f specular_tint{1.0f};
    float anisotropic = 0.0f;
    float anisotropic_rotation = 0.0f;  // turns
    V3f tangent{0.0f};
    float transmission_weight = 0.0f;
    float coat_weight = 0.0f;
    float coat_roughness = 0.03f;
    float coat_ior = 1.5f;
    Color3f coat_tint{1.0f};
    V3f coat_normal{0.0f};
    float sheen_weight = 0.0f;
    float sheen_roughness = 0.5f;
    Color3f sheen_tint{1.0f};
    Color3f emission_color{1.0f};
    float emission_strength = 0.0f;
    float thin_film_thickness_nm = 0.0f;
    float thin_film_ior = 1.33f;
    // Compensate the energy that single scattering loses (distribution MULTI_GGX).
    bool multiple_scattering = true;
    LobeKind subsurface_method = LobeKind::RandomWalk;
    WorkingSpace working_space = WorkingSpace::Rec709;  // of all colours
    // As PathState has them.
    bool shows_reflections = true;
    bool shows_refractions = true;
    bool after_diffuse = false;
    bool subsurface_always_walks = false;
};

// Adds its lobes, `weight` times, to a mixture seen along point.wo.
void add_principled(Bsdf& bsdf,
                    const PrincipledInputs& inputs,
                    float weight,
                    const ShadingPoint& point);

// Radiance towards point.wo.
[[nodiscard]] Color3f principled_emission(const PrincipledInputs& inputs,
                                          const ShadingPoint& point);

}  // namespace eye_render
