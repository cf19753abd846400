#include "analysis/diffraction.h"

#include "base/units.h"

namespace eye_render {

namespace {

// The first zero of the Bessel function J1, over pi.
constexpr double airy_radius_factor = 3.8317059702075123156 / pi;

double m_from_nm(double wavelength_nm) { return wavelength_nm * 1e-9; }

}  // namespace

double airy_radius_rad(double pupil_diameter_m, double wavelength_nm)
{
    return airy_radius_factor * m_from_nm(wavelength_nm) / pupil_diameter_m;
}

double airy_defocus_d(double pupil_diameter_m, double wavelength_nm)
{
    return 2.0 * airy_radius_rad(pupil_diameter_m, wavelength_nm) / pupil_diameter_m;
}

double quarter_wave_defocus_d(double pupil_diameter_m, double wavelength_nm)
{
    return 2.0 * m_from_nm(wavelength_nm) / (pupil_diameter_m * pupil_diameter_m);
}

double diffraction_cutoff_cpd(double pupil_diameter_m, double wavelength_nm)
{
    return rad_from_deg(pupil_diameter_m / m_from_nm(wavelength_nm));
}

double diffraction_mtf(double frequency_cpd, double pupil_diameter_m, double wavelength_nm)
{
    const double s =
        std::abs(frequency_cpd) / diffraction_cutoff_cpd(pupil_diameter_m, wavelength_nm);
    if (s >= 1.0) {
        return 0.0;
    }
    return 2.0 / pi * (std::acos(s) - s * std::sqrt(1.0 - s * s));
}

bool diffraction_dominates(const SpotMoments& moments,
                           double pupil_diameter_m,
                           double wavelength_nm)
{
    const double airy_diameter_arcmin =
        arcmin_from_rad(2.0 * airy_radius_rad(pupil_diameter_m, wavelength_nm));
    return spot_ellipse(moments).major_arcmin < airy_diameter_arcmin;
}

}  // namespace eye_render
