#include "render/light_path_limits.h"

#include "base/error.h"

namespace eye_render {

void require_valid(const LightPathLimits& limits)
{
    require_range("diffuse_bounces", limits.diffuse_bounces, 0, most_bounces, "");
    require_range("glossy_bounces", limits.glossy_bounces, 0, most_bounces, "");
    require_range("transmission_bounces", limits.transmission_bounces, 0, most_bounces, "");
    require_range("volume_bounces", limits.volume_bounces, 0, most_bounces, "");
    require_range("transparent_bounces", limits.transparent_bounces, 0, most_bounces, "");
    constexpr double most_light = 1e10;
    require_range("filter_glossy", static_cast<double>(limits.filter_glossy), 0.0, 1e4, "");
    require_range("clamp_direct", static_cast<double>(limits.clamp_direct), 0.0, most_light, "");
    require_range("clamp_indirect", static_cast<double>(limits.clamp_indirect), 0.0, most_light,
                  "");
}

}  // namespace eye_render
