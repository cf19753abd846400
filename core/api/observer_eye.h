// From the observer to the eye that looks: what it focuses on, and how wide its pupil is in the
// light of this scene.

#pragma once

#include "api/observer.h"
#include "render/camera.h"
#include "scene/scene.h"

#include <memory>
#include <string>
#include <vector>

namespace eye_render {

struct ObserverEye {
    std::shared_ptr<const EyeModel> model;
    double pupil_mm = 0.0;
    double accommodation_d = 0.0;
    double amplitude_d = 0.0;       // the most that the age and the eye model allow
    double focus_distance_m = 0.0;  // what it tries to see sharply; infinity when far or relaxed
    // What an automatic pupil answered to; 0 with a manual one.
    double luminance_cd_m2 = 0.0;
    double field_area_deg2 = 0.0;
    std::vector<std::string> pupil_clamps;  // as PupilSize has them
    std::vector<std::string> notes;         // on accommodation, in sentences
};

// The observer's eye with that pupil and accommodation. Throws as make_eye does.
[[nodiscard]] std::unique_ptr<EyeModel> eye_in_state(const Observer& observer,
                                                     double pupil_mm,
                                                     double accommodation_d);

// Looks along the axis for FocusMode::Center, and traces a small picture for an automatic pupil,
// on at most `threads` threads (0: all the processor has).
[[nodiscard]] ObserverEye make_observer_eye(const Observer& observer,
                                            const std::shared_ptr<const Scene>& scene,
                                            const CameraFrame& frame,
                                            int threads);

}  // namespace eye_render
