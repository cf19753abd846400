// Light linking: which objects a light lights, and which of them throw its shadows, as Blender's
// light and shadow linking say.
//
// Objects that the same lights light are one class. The objects that alone block some light are a
// set, numbered from 1; set 0 is whatever throws shadows.

#pragma once

#include "scene/ray.h"
#include "scene/visibility.h"

#include <cstdint>

namespace eye_render {

inline constexpr int max_light_classes = 64;
// Masks of rays have no room for more.
inline constexpr int max_blocker_sets = 32 - 2 * Visibility::kind_count;

// Of a lamp, or of an object that shines.
struct LightLinks {
    std::uint64_t lit_classes = ~std::uint64_t{0};  // bit n: it lights objects of class n
    int blocker_set = 0;

    [[nodiscard]] bool lights(int light_class) const
    {
        return (lit_classes >> light_class & 1u) != 0;
    }
};

// Of what is no object, such as a place in a medium.
inline constexpr int light_class_of_media = 0;

// Of an object.
struct LinkedObject {
    int light_class = 0;
    std::uint32_t blocker_sets = 0;  // bit n - 1: it is in set n
};

// The rays that meet an object of that visibility; a shadow catcher is met, too, by those that see
// catchers only.
[[nodiscard]] inline RayMask met_by(const Visibility& visibility,
                                    bool is_shadow_catcher,
                                    const LinkedObject& linked)
{
    const RayMask kinds = visibility.mask();
    const RayMask of_catcher = is_shadow_catcher ? kinds << Visibility::kind_count : 0u;
    const RayMask of_blocker = visibility.to_shadow ? linked.blocker_sets : 0u;
    return kinds | of_catcher | of_blocker << 2 * Visibility::kind_count;
}

// Of the ray that the path is about to follow, to a light of that blocker set if it is a shadow's.
[[nodiscard]] inline RayMask ray_mask(const PathState& path, int blocker_set = 0)
{
    if (path.sees_catchers_only) {
        return Visibility::ray_mask(path) << Visibility::kind_count;
    }
    return blocker_set == 0 ? Visibility::ray_mask(path)
                            : 1u << (2 * Visibility::kind_count + blocker_set - 1);
}

}  // namespace eye_render
