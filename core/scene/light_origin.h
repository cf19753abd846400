// What light is from: for passes that tell it apart.

#pragma once

namespace eye_render {

inline constexpr int no_light_group = -1;

struct LightOrigin {
    bool is_world = false;       // or a lamp or surface
    int group = no_light_group;  // number of the scene's light group
};

}  // namespace eye_render
