// What a scene is not given: numbers that no query should have to look for.

#pragma once

#include "scene/scene_data.h"

#include <string>

namespace eye_render {

// All throw std::invalid_argument that begins with `what`, or with the name of the number.
void require_finite(const std::string& what, const M44d& matrix);
// Of a motion: none, or at least two.
void require_steps(const std::string& what, std::size_t steps);
void require_valid(const LampPose& pose);
void require_valid(const LightLinks& links);
void require_valid(const LinkedObject& linked);

}  // namespace eye_render
