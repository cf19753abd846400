#include "render/shadow_catcher.h"

#include <algorithm>

namespace eye_render {

namespace {

// One number for the shadow: a colour cannot cover.
[[nodiscard]] double shade_left(const CaughtLight& light)
{
    const V3d factor = catcher_factor(light);
    return std::clamp((factor.x + factor.y + factor.z) / 3.0, 0.0, 1.0);
}

}  // namespace

V3d catcher_factor(const CaughtLight& light)
{
    const double caught = light.alpha - light.matte_alpha;
    if (!(caught > 0.0)) {
        return V3d(1.0);
    }
    V3d factor;
    for (int c = 0; c < 3; ++c) {
        // Where nothing lights the bare place there is nothing to darken.
        const double ratio =
            light.bare[c] > 0.0 ? (light.all[c] - light.matte[c]) / light.bare[c] : 1.0;
        // At an edge against a transparent film the rest of the pixel is not darkened.
        factor[c] = 1.0 - light.alpha + light.alpha * ratio;
    }
    return factor;
}

std::array<double, 4> without_shadow(const CaughtLight& light)
{
    return {light.matte.x, light.matte.y, light.matte.z, light.matte_alpha};
}

std::array<double, 4> over_nothing(const CaughtLight& light)
{
    const double shadow = (1.0 - light.matte_alpha) * (1.0 - shade_left(light));
    return {light.matte.x, light.matte.y, light.matte.z, light.matte_alpha + shadow};
}

std::array<double, 4> over_world(const CaughtLight& light)
{
    const V3d color = light.matte + light.behind * shade_left(light);
    return {color.x, color.y, color.z, light.alpha};
}

}  // namespace eye_render
