// The principal diameters are p |lambda| for the eigenvalues m +- a of E.

#include "analysis/blur_ellipse.h"

#include "base/units.h"

namespace eye_render {

BlurEllipse blur_ellipse(const PowerMatrix& error_d, double pupil_diameter_m)
{
    // Diameters that differ by less than an error of a nanodioptre are round: far below any blur
    // that could be seen, far above the rounding of E.
    constexpr double round_d = 1e-9;

    const double mean_d = error_d.mean_d();
    const double astigmatism_d = error_d.astigmatism_d();
    const double major_d = error_d.largest_magnitude_d();
    const double minor_d = std::abs(std::abs(mean_d) - astigmatism_d);
    BlurEllipse blur;
    blur.major_arcmin = arcmin_from_rad(pupil_diameter_m * major_d);
    blur.minor_arcmin = arcmin_from_rad(pupil_diameter_m * minor_d);
    blur.rms_radius_arcmin = 0.25 * std::hypot(blur.major_arcmin, blur.minor_arcmin);
    if (major_d - minor_d > round_d) {
        // The direction of the more positive eigenvalue, which is the larger one if m > 0.
        const double positive_deg =
            deg_from_rad(0.5 * std::atan2(error_d.j45_d(), error_d.j0_d()));
        const double angle_deg = std::fmod(positive_deg + (mean_d < 0.0 ? 270.0 : 180.0), 180.0);
        blur.angle_deg = angle_deg;
    }
    return blur;
}

double line_spread_rms_arcmin(const PowerMatrix& error_d,
                              double pupil_diameter_m,
                              double line_angle_deg)
{
    const double angle_rad = rad_from_deg(line_angle_deg);
    const V2d across(-std::sin(angle_rad), std::cos(angle_rad));
    // A semicircle of half width h = R |E n|, whose root mean square is h / 2.
    return arcmin_from_rad(0.25 * pupil_diameter_m * (error_d * across).length());
}

}  // namespace eye_render
