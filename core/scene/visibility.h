// Which rays see an object, as Blender's ray visibility says.

#pragma once

#include "shading/node.h"

namespace eye_render {

struct Visibility {
    bool to_camera = true;
    bool to_diffuse = true;
    bool to_glossy = true;
    bool to_transmission = true;
    bool to_shadow = true;

    [[nodiscard]] bool to_all() const
    {
        return to_camera && to_diffuse && to_glossy && to_transmission && to_shadow;
    }

    // For the ray that the path is about to follow.
    [[nodiscard]] bool sees(const PathState& path) const
    {
        if (path.is_shadow) {
            return to_shadow;
        }
        if (path.is_camera) {
            return to_camera;
        }
        if (path.is_transmission) {
            return to_transmission;
        }
        return path.is_diffuse ? to_diffuse : to_glossy;
    }
};

}  // namespace eye_render
