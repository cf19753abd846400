// What all places of a scene share.

#pragma once

#include "scene/textures.h"
#include "shading/hit_attributes.h"

namespace eye_render {

struct SceneFrame {
    V3d eye_position_world{0.0};
    ViewFrame view{};
    ViewFrame direction_view{};  // the same for directions: turned, not moved
    const TextureSet* textures = nullptr;
};

}  // namespace eye_render
