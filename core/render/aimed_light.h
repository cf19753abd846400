// Aiming at lights: one light, and one place on it, for a point that was weighed.

#pragma once

#include "render/sample_sequence.h"
#include "scene/scene.h"

#include <array>
#include <optional>

namespace eye_render {

// A number in [0, 1) to choose a light by, of two such: a float's 24 bits are too few to choose
// among many.
[[nodiscard]] inline double light_choice(float u, float finer)
{
    return u + 0x1p-24 * static_cast<double>(finer);
}

// What lights an object of that class on such a path; nothing if that was not what was chosen.
[[nodiscard]] inline std::optional<IncomingLight> aim_at_light(const Scene& scene,
                                                               const LitPoint& point,
                                                               const PathState& path,
                                                               int light_class,
                                                               const std::array<float, 4>& u)
{
    auto light = scene.sample_light(point, light_choice(u[2], u[3]), V2f(u[0], u[1]));
    if (light && (!light->links.lights(light_class) ||
                  (path.sees_catchers_only && !light->is_of_catcher))) {
        light.reset();
    }
    return light;
}

}  // namespace eye_render
