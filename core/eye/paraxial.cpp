// The eye to first order, exact for any cylinder: slope = u - K p with the symmetric 2x2 matrix
// K = A I - Rx of the retina's conjugate vergences (Long 1976). There is no division, so focus at
// infinity and hyperopia (K < 0, a virtual conjugate behind the eye) are ordinary values, and
// K = 0 returns the chief slope bit for bit. With slopes per unit of forward travel a spherical K
// focuses on the plane Z = -1/K. K changes with wavelength as the chromatic eye's.

#include "eye/models.h"
#include "optics/chromatic.h"

namespace eye_render {

namespace {

class ParaxialEye final : public EyeModel {
public:
    ParaxialEye(const PowerMatrix& retinal_conjugate_d, double pupil_diameter_m)
        : retinal_conjugate_d_(retinal_conjugate_d), pupil_diameter_m_(pupil_diameter_m)
    {
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double wavelength_nm) const override
    {
        const PowerMatrix focus_d =
            retinal_conjugate_d_ - PowerMatrix::sphere(chromatic_difference_d(wavelength_nm));
        return {.origin_eye_m = {pupil_point_m.x, pupil_point_m.y, 0.0},
                .slope = chief_slope - focus_d * pupil_point_m};
    }

    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return retinal_conjugate_d_; }

    [[nodiscard]] double pupil_diameter_m() const override { return pupil_diameter_m_; }

private:
    PowerMatrix retinal_conjugate_d_;
    double pupil_diameter_m_;
};

}  // namespace

std::unique_ptr<EyeModel> make_paraxial_eye(const PowerMatrix& retinal_conjugate_d,
                                            double pupil_diameter_m)
{
    return std::make_unique<ParaxialEye>(retinal_conjugate_d, pupil_diameter_m);
}

}  // namespace eye_render
