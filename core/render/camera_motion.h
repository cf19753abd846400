// The camera while the shutter is open: between known poses it moves straight and turns evenly.

#pragma once

#include "render/camera.h"

#include <Imath/ImathMatrix.h>
#include <Imath/ImathQuat.h>

#include <vector>

namespace eye_render {

class CameraMotion {
public:
    // At the times of scene/motion.h, at least two.
    explicit CameraMotion(std::vector<CameraFrame> poses);

    [[nodiscard]] CameraFrame at(float time) const;

private:
    std::vector<CameraFrame> poses_;
    std::vector<Imath::Quatd> turns_;
    // From axes across each other to the poses' own: one for most cameras, mirrored for some.
    std::vector<Imath::M33d> shears_;
};

}  // namespace eye_render
