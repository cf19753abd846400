// Eyes that no prescription makes, to test what is made of their rays.

#pragma once

#include "eye/eye_model.h"

namespace eye_render::test {

// An emmetropic eye whose upper half is covered, and which lets half of the light through.
class HalfEye final : public EyeModel {
public:
    [[nodiscard]] EyeRay ray(const V2d& slope, const V2d& pupil_point_m, double) const override
    {
        if (pupil_point_m.y > 0.0) {
            return {.fate = RayFate::Vignetted, .weight = 0.0};
        }
        return {.origin_eye_m = {pupil_point_m.x, pupil_point_m.y, 0.0},
                .slope = slope,
                .weight = 0.5};
    }
    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return {}; }
    [[nodiscard]] double pupil_diameter_m() const override { return 2e-3; }
};

class ClosedEye final : public EyeModel {
public:
    [[nodiscard]] EyeRay ray(const V2d&, const V2d&, double) const override
    {
        return {.fate = RayFate::Vignetted, .weight = 0.0};
    }
    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return {}; }
    [[nodiscard]] double pupil_diameter_m() const override { return 2e-3; }
};

}  // namespace eye_render::test
