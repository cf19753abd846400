// How large a blur a picture can have, to decide whether it needs a lens at all.

#pragma once

#include "render/camera.h"

namespace eye_render {

// Diameter of the largest blur of anything between `nearest_m` from the eye and infinity, as the
// picture's slope: an upper bound over the frame's centre and corners, found by rays through the
// pupil's rim and half-way to it. With `chromatic`, over the display's wavelengths, too.
[[nodiscard]] double largest_blur_slope(const EyeModel& eye,
                                        const CameraFrame& frame,
                                        double nearest_m,
                                        bool chromatic);

}  // namespace eye_render
