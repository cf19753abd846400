// The paraxial eye with the aberrations that an aberrometer measured: slope = u - K p - grad W(p).
//
// The prescription states the focus, and the wavefront what no prescription corrects. So of W only
// the third and higher powers of the distance from the pupil's centre count. Left out are piston,
// tilt and the second order of its Zernike terms, which the prescription replaces, and likewise
// the tilt and curvature that the higher Zernike terms have at the centre: coma and spherical
// aberration are balanced with tilt and defocus to be least over the pupil they were measured
// with. Thus the ray through the centre keeps the chief slope, K has the same meaning as in the
// paraxial eye, which this one becomes as the pupil closes, and a wavefront means the same whether
// it is given over its own pupil or rescaled to a smaller one. It is also where optometrists
// refract to: paraxial curvature predicts their prescription best (Thibos, Hong, Bradley &
// Applegate 2004).
//
// Longitudinal chromatic aberration is the chromatic eye's; W is the same at all wavelengths.

#include "base/units.h"
#include "eye/models.h"
#include "optics/chromatic.h"

namespace eye_render {

namespace {

class WavefrontEye final : public EyeModel {
public:
    WavefrontEye(const PowerMatrix& retinal_conjugate_d,
                 double pupil_diameter_m,
                 const Wavefront& wavefront_camera)
        : retinal_conjugate_d_(retinal_conjugate_d), pupil_diameter_m_(pupil_diameter_m),
          measured_radius_m_(0.5 * wavefront_camera.pupil_diameter_m),
          aberrations_um_(polynomial_um(wavefront_camera))
    {
        aberrations_um_.drop_below(3);
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double wavelength_nm) const override
    {
        const PowerMatrix focus_d =
            retinal_conjugate_d_ - PowerMatrix::sphere(chromatic_difference_d(wavelength_nm));
        const V2d steepness = aberrations_um_.gradient(pupil_point_m / measured_radius_m_) *
                              (m_from_um(1.0) / measured_radius_m_);
        return {.origin_eye_m = {pupil_point_m.x, pupil_point_m.y, 0.0},
                .slope = chief_slope - focus_d * pupil_point_m - steepness};
    }

    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return retinal_conjugate_d_; }

    [[nodiscard]] double pupil_diameter_m() const override { return pupil_diameter_m_; }

    [[nodiscard]] bool is_first_order() const override { return false; }

private:
    PowerMatrix retinal_conjugate_d_;
    double pupil_diameter_m_;
    double measured_radius_m_;
    PupilPolynomial aberrations_um_;  // over points in units of the measured radius
};

}  // namespace

std::unique_ptr<EyeModel> make_wavefront_eye(const PowerMatrix& retinal_conjugate_d,
                                             double pupil_diameter_m,
                                             const Wavefront& wavefront)
{
    return std::make_unique<WavefrontEye>(retinal_conjugate_d, pupil_diameter_m,
                                          mirrored(wavefront));
}

}  // namespace eye_render
