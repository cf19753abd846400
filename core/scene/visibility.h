// Which rays see an object or a lamp, as Blender's ray visibility says.

#pragma once

#include "scene/ray.h"
#include "shading/node.h"

namespace eye_render {

struct Visibility {
    bool to_camera = true;
    bool to_diffuse = true;
    bool to_glossy = true;
    bool to_transmission = true;
    bool to_volume_scatter = true;
    bool to_shadow = true;

    [[nodiscard]] bool to_all_scattering() const
    {
        return to_diffuse && to_glossy && to_transmission;
    }

    // Light that is sampled where it is scattered: the part that a ray of the same scattering
    // would see, by `shines_on` of a lamp and the world, by `sees` of a surface.
    [[nodiscard]] Color3f seen_part(const BsdfParts& parts,
                                    bool is_transmitted,
                                    bool is_surface) const
    {
        const bool to_wide = is_surface && is_transmitted ? to_transmission : to_diffuse;
        Color3f sum(0.0f);
        sum += to_wide ? parts.diffuse : Color3f(0.0f);
        sum += to_glossy ? parts.glossy : Color3f(0.0f);
        sum += to_transmission ? parts.transmission : Color3f(0.0f);
        return sum;
    }

    // Of a lamp or the world, on the ray that the path is about to follow. Where a wide lobe let
    // the light pass it is diffuse to lights and transmitted to objects, as in Cycles.
    [[nodiscard]] bool shines_on(const PathState& path) const
    {
        return path.is_diffuse ? to_diffuse : sees(path);
    }

    // Of a surface, for the ray that the path is about to follow.
    [[nodiscard]] bool sees(const PathState& path) const { return (mask() & ray_mask(path)) != 0; }

    // Of a placement: the kinds of rays that meet it.
    [[nodiscard]] RayMask mask() const
    {
        return (to_camera ? camera : 0u) | (to_diffuse ? diffuse : 0u) |
               (to_glossy ? glossy : 0u) | (to_transmission ? transmission : 0u) |
               (to_volume_scatter ? volume_scatter : 0u) | (to_shadow ? shadow : 0u);
    }

    // The kind of the ray that the path is about to follow.
    [[nodiscard]] static RayMask ray_mask(const PathState& path)
    {
        if (path.is_shadow) {
            return shadow;
        }
        if (path.is_camera) {
            return camera;
        }
        if (path.is_volume_scatter) {
            return volume_scatter;
        }
        if (path.is_transmission) {
            return transmission;
        }
        return path.is_diffuse ? diffuse : glossy;
    }

    static constexpr RayMask camera = 1u << 0;
    static constexpr RayMask diffuse = 1u << 1;
    static constexpr RayMask glossy = 1u << 2;
    static constexpr RayMask transmission = 1u << 3;
    static constexpr RayMask volume_scatter = 1u << 4;
    static constexpr RayMask shadow = 1u << 5;
    static constexpr int kind_count = 6;
};

}  // namespace eye_render
