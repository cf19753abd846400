#include "steepness.h"

#include "base/units.h"
#include "optics/chromatic.h"

#include <algorithm>
#include <cmath>

namespace eye_render::test {

namespace {

// Largest absolute eigenvalue of a prescription.
double strongest_d(double sphere_d, double cylinder_d)
{
    return std::max(std::abs(sphere_d), std::abs(sphere_d + cylinder_d));
}

// Over the distance that the prescription is referred.
double referral_m(const Trial& trial)
{
    // The paper's eye takes it as written, unless a lens is worn.
    if (trial.model == EyeModelKind::Paper && !trial.glasses) return 0.0;
    switch (trial.rx_plane) {
    case RxPlane::Spectacle: return m_from_mm(trial.vertex_mm) + cornea_to_entrance_pupil_m;
    case RxPlane::Cornea: return cornea_to_entrance_pupil_m;
    case RxPlane::EntrancePupil: break;
    }
    return 0.0;
}

// Of the wavefront of 1 um scale over 9 mm. Markov's inequality on the disk, |grad Z| <= n^2
// max|Z| for degree n and twice for the second derivative, max|Z| = sqrt(2 (n + 1)), coefficients
// of at most 1 um: summed over the terms of orders 3 to 6. Tilt and curvature at the centre, which
// the eye leaves out, are at most as steep again each.
struct WavefrontSteepness {
    double slope = 0.0;            // per um of scale
    double curvature_per_m = 0.0;  // of slope
};

WavefrontSteepness wavefront_steepness()
{
    constexpr double radius_m = 0.5 * max_pupil_diameter_m;
    WavefrontSteepness sum;
    for (int n = 3; n <= 6; ++n) {
        const double slope =
            (n + 1) * std::sqrt(2.0 * (n + 1)) * n * n * m_from_um(1.0) / radius_m;
        sum.slope += 3.0 * slope;
        sum.curvature_per_m += 3.0 * slope * n * n / radius_m;
    }
    return sum;
}

}  // namespace

Steepness::Steepness(const Trial& trial) : trial_(trial), point_m_(pupil_point_m(trial).length())
{
    const double distance_m = referral_m(trial);
    const double meridians_d[] = {trial.sphere_d, trial.sphere_d + trial.cylinder_d};
    double least_left = 1.0;
    for (const double meridian_d : meridians_d) {
        const double left = 1.0 - distance_m * meridian_d;
        least_left = std::min(least_left, left);
        referred_d_ = std::max(referred_d_, std::abs(meridian_d / left));
    }
    referral_ = 1.0 / (least_left * least_left);
    if (trial.model == EyeModelKind::Paper) {
        // 1/f between the meridians' is (f/f_i)^2 times as sensitive to f_i's power.
        const double emmetrope_d = 1.0 / m_from_mm(trial.eye_length_mm);
        double weakest_d = HUGE_VAL;
        double most_d = 0.0;
        for (const double meridian_d : meridians_d) {
            const double power_d = emmetrope_d - meridian_d / (1.0 - distance_m * meridian_d);
            weakest_d = std::min(weakest_d, power_d);
            most_d = std::max(most_d, power_d);
        }
        const double ratio = most_d / weakest_d;
        interpolation_ = (2.0 / pi) * most_d * most_d * (1.0 / weakest_d - 1.0 / most_d);
        // A small cylinder turns as fast as it grows: 2 / pi for its direction.
        referral_ *= (1.0 + 2.0 / pi) * ratio * ratio;
    }
    if (trial.glasses) {
        lens_d_ = test::strongest_d(trial.lens_sphere_d, trial.lens_cylinder_d);
        lens_m_ = m_from_mm(trial.vertex_mm) + cornea_to_entrance_pupil_m;
        gain_ = 1.0 + lens_m_ * lens_d_;
    }
    constexpr double most_chromatic_d = 2.0;
    strongest_d_ = referred_d_ + trial.accommodation_d + most_chromatic_d;
    inner_slope_ = chief_slope(trial).length() + strongest_d_ * point_m_;
    if (trial.model == EyeModelKind::Wavefront) {
        inner_slope_ += std::abs(trial.wavefront_um) * wavefront_steepness().slope;
    }
}

double Steepness::of_pupil_point() const
{
    double inner_d = strongest_d_ + interpolation_;
    if (trial_.model == EyeModelKind::Wavefront) {
        inner_d += std::abs(trial_.wavefront_um) * wavefront_steepness().curvature_per_m;
    }
    return gain_ * inner_d + lens_d_;
}

double Steepness::of_lens(const Input& input) const
{
    const double per_d = lens_m_ * inner_slope_ + point_m_;
    if (input.value == &Trial::lens_axis_deg) {
        return std::abs(trial_.lens_cylinder_d) * rad_from_deg(1.0) * per_d;
    }
    return per_d;
}

double Steepness::of(const Input& input) const
{
    if (trial_.model == EyeModelKind::Pinhole) {
        const bool chief = input.value == &Trial::slope_x || input.value == &Trial::slope_y;
        return chief ? 1.0 : 0.0;
    }
    const double per_d = gain_ * point_m_;
    const double radius_m = m_from_mm(0.5 * trial_.pupil_mm);
    if (input.value == &Trial::slope_x || input.value == &Trial::slope_y) return gain_;
    if (input.value == &Trial::sphere_d || input.value == &Trial::cylinder_d) {
        return referral_ * per_d;
    }
    if (input.value == &Trial::axis_deg) {
        return std::abs(trial_.cylinder_d) * rad_from_deg(1.0) * referral_ * per_d;
    }
    if (input.value == &Trial::vertex_mm) {
        const bool referred = referral_m(trial_) > cornea_to_entrance_pupil_m;
        const double eye = referred ? referral_ * referred_d_ * referred_d_ * per_d : 0.0;
        return m_from_mm(1.0) * (eye + lens_d_ * inner_slope_);
    }
    if (input.value == &Trial::pupil_mm) {
        return of_pupil_point() * trial_.pupil_share * m_from_mm(0.5);
    }
    if (input.value == &Trial::pupil_share) return of_pupil_point() * radius_m;
    if (input.value == &Trial::pupil_angle_deg) {
        return of_pupil_point() * point_m_ * rad_from_deg(1.0);
    }
    if (input.value == &Trial::accommodation_d) return per_d;
    if (input.value == &Trial::wavelength_nm) {
        // The derivative of 633.46 / (wavelength - 214.102), steepest in the violet.
        const double from_pole_nm = min_wavelength_nm - 214.102;
        return 633.46 / (from_pole_nm * from_pole_nm) * per_d;
    }
    if (input.value == &Trial::eye_length_mm && trial_.model == EyeModelKind::Paper) {
        const double length_m = m_from_mm(trial_.eye_length_mm);
        return m_from_mm(1.0) * referral_ / (length_m * length_m) * per_d;
    }
    if (input.value == &Trial::wavefront_um && trial_.model == EyeModelKind::Wavefront) {
        return gain_ * wavefront_steepness().slope;
    }
    const bool of_glasses =
        std::any_of(lens_inputs.begin(), lens_inputs.end(),
                    [&](const Input& lens) { return lens.value == input.value; });
    return of_glasses && trial_.glasses ? of_lens(input) : 0.0;
}

}  // namespace eye_render::test
