#include "api/scene_checks.h"

#include "base/error.h"

#include <cmath>
#include <stdexcept>

namespace eye_render {

void require_finite(const std::string& what, const M44d& matrix)
{
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 4; ++j) {
            if (!std::isfinite(matrix[i][j])) {
                throw std::invalid_argument(what + " has an entry that is not finite");
            }
        }
    }
}

void require_steps(const std::string& what, std::size_t steps)
{
    if (steps == 1) {
        throw std::invalid_argument(what + " has 1 step; expected none or at least 2");
    }
}

void require_valid(const LampPose& pose)
{
    require_finite("world_from_light", pose.world_from_light);
    static_cast<void>(make_lamp(pose.settings));  // for its checks
}

void require_valid(const LightLinks& links)
{
    require_range("blocker_set", links.blocker_set, 0, max_blocker_sets, "");
}

void require_valid(const LinkedObject& linked)
{
    require_range("light_class", linked.light_class, 0, max_light_classes - 1, "");
    require_range("blocker_sets", linked.blocker_sets, 0, (1u << max_blocker_sets) - 1u, "");
}

}  // namespace eye_render
