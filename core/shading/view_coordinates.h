// A place as the observer's camera sees it.

#pragma once

#include "shading/hit_attributes.h"

namespace eye_render {

// Right, up and ahead, scene units: Blender's camera coordinates in nodes look along +Z.
[[nodiscard]] inline V3f view_position(const HitAttributes& attributes)
{
    const V3f p = attributes.position_world() * attributes.view().camera_from_world;
    return {p.x, p.y, -p.z};
}

// 0 to 1 over the picture, from the bottom left. The projection goes on behind the camera, where
// it is turned over, as in Cycles.
[[nodiscard]] inline V3f window_position(const HitAttributes& attributes)
{
    const V3f p = view_position(attributes);
    if (p.z == 0.0f) {
        return V3f(0.0f);
    }
    const ViewFrame& view = attributes.view();
    const V2f slope(p.x / p.z, p.y / p.z);
    const V2f window = (slope - view.slope_first) / (view.slope_last - view.slope_first);
    return {window.x, window.y, 0.0f};
}

}  // namespace eye_render
