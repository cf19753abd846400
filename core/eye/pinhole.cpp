// The eye without blur: every ray leaves the centre of the pupil along its chief slope.

#include "eye/models.h"

namespace eye_render {

namespace {

class PinholeEye final : public EyeModel {
public:
    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& /*pupil_point_m*/,
                             double /*wavelength_nm*/) const override
    {
        return {.slope = chief_slope};
    }

    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return {}; }

    [[nodiscard]] bool is_chromatic() const override { return false; }

    [[nodiscard]] double pupil_diameter_m() const override { return 0.0; }
};

}  // namespace

std::unique_ptr<EyeModel> make_pinhole_eye() { return std::make_unique<PinholeEye>(); }

}  // namespace eye_render
