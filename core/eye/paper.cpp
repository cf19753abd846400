// The eye of Wang & Xiao 2013, "Simulation of Human Eye Optical System Properties and Depth of
// Field Variation" (IJMLC 3(4)), equations 1 to 8, with its astigmatism.
//
// Their ray (6), RB = (D + d)/d RO + D/L PR, divided by D and with d the focal length f of
// equation 8, D the distance accommodated for and L = d_eye, is
//     slope = u - (1/f + 1/D - 1/d_eye) p,    1/f = 1/d_eye - ds,
// which has no trouble at D = infinity. Astigmatism interpolates f linearly over the angle between
// the pupil point and the cylinder axis, and bends the ray towards the centre only.
//
// Kept to reproduce the paper. Against `paraxial` it drops the bending across the meridian, up to
// half the cylinder, so it has no focal lines and no circle of least confusion. The paper refers
// the prescription to the lens: no vertex distance enters. It says that the most curved meridian
// lies *at* the axis, but its own Fig. 11 agrees with the clinical meaning, which is used here:
// the cylinder acts across the axis.

#include "eye/models.h"

#include "base/error.h"
#include "base/units.h"

namespace eye_render {

namespace {

// Equation 8. An eye prescribed 1/d_eye (59 D) or more would be a lens without power.
double focal_length_m(double rx_d, double eye_length_m)
{
    constexpr double weakest = 0.1;  // of the emmetropic eye's power
    const double relative_power = 1.0 - eye_length_m * rx_d;
    if (!(relative_power >= weakest)) {
        throw std::invalid_argument(
            "a prescription of " + number_text(rx_d) + " D needs a lens without power in an eye " +
            number_text(mm_from_m(eye_length_m)) + " mm long; expected at most " +
            number_text((1.0 - weakest) / eye_length_m) + " D");
    }
    return eye_length_m / relative_power;
}

class PaperEye final : public EyeModel {
public:
    PaperEye(const PowerMatrix& rx_camera,
             double accommodation_d,
             double pupil_diameter_m,
             double eye_length_m)
        : retinal_conjugate_d_(PowerMatrix::sphere(accommodation_d) - rx_camera),
          accommodation_d_(accommodation_d), pupil_diameter_m_(pupil_diameter_m),
          emmetropic_power_d_(1.0 / eye_length_m),
          along_m_(focal_length_m(rx_camera.mean_d() + rx_camera.astigmatism_d(), eye_length_m)),
          across_m_(focal_length_m(rx_camera.mean_d() - rx_camera.astigmatism_d(), eye_length_m))
    {
        // The minus form's axis is the direction of the more positive principal power.
        const double axis_rad = 0.5 * std::atan2(rx_camera.j45_d(), rx_camera.j0_d());
        axis_camera_ = {std::cos(axis_rad), std::sin(axis_rad)};
    }

    [[nodiscard]] EyeRay ray(const V2d& chief_slope,
                             const V2d& pupil_point_m,
                             double /*wavelength_nm*/) const override
    {
        const double along = std::abs(axis_camera_.dot(pupil_point_m));
        const double across = std::abs(axis_camera_.cross(pupil_point_m));
        const double quarter_turns = std::atan2(across, along) * (2.0 / pi);
        const double f_m = along_m_ + (across_m_ - along_m_) * quarter_turns;
        const double conjugate_d = 1.0 / f_m - emmetropic_power_d_ + accommodation_d_;
        return {.origin_eye_m = {pupil_point_m.x, pupil_point_m.y, 0.0},
                .slope = chief_slope - pupil_point_m * conjugate_d};
    }

    // What the eye would do with the exact cylinder; the interpolated one is no matrix.
    [[nodiscard]] PowerMatrix retinal_conjugate_d() const override { return retinal_conjugate_d_; }

    [[nodiscard]] bool is_chromatic() const override { return false; }

    [[nodiscard]] double pupil_diameter_m() const override { return pupil_diameter_m_; }

private:
    PowerMatrix retinal_conjugate_d_;
    double accommodation_d_;
    double pupil_diameter_m_;
    double emmetropic_power_d_;
    double along_m_;   // focal length in the meridian of the axis
    double across_m_;  // and at right angles to it
    V2d axis_camera_{1.0, 0.0};
};

}  // namespace

std::unique_ptr<EyeModel> make_paper_eye(const PowerMatrix& rx_camera,
                                         double accommodation_d,
                                         double pupil_diameter_m,
                                         double eye_length_m)
{
    return std::make_unique<PaperEye>(rx_camera, accommodation_d, pupil_diameter_m, eye_length_m);
}

}  // namespace eye_render
