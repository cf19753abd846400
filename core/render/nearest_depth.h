// How near the eye a scene comes: what the largest blur is reckoned from.

#pragma once

#include "render/camera.h"
#include "scene/scene_data.h"

namespace eye_render {

// Along the viewing axis, scene units, of the nearest thing in front of the eye that the camera
// may see, not nearer than the clipping plane; infinity when there is nothing. Boxes stand for
// geometries and lamps, so it is a lower bound; what moves is looked at in all of its known
// places.
[[nodiscard]] double nearest_depth(const SceneData& scene, const CameraFrame& frame);

}  // namespace eye_render
