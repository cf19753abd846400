#include "analysis/mtf.h"

#include "base/units.h"

#include <complex>

namespace eye_render {

namespace {

struct Phasor {
    double angle_deg;  // across the bars
    double weight;
    // Whose copies of the pupil, up to this distance apart, both hold the ray.
    double reach_m;
};

// Half the distance from p to the round pupil's edge in both directions along `across`.
double reach(const V2d& p, const V2d& across, double radius_m)
{
    const double along_m = std::abs(p.dot(across));
    const double aside_m = p.cross(across);
    const double half_chord_m = std::sqrt(std::max(0.0, radius_m * radius_m - aside_m * aside_m));
    return 2.0 * (half_chord_m - along_m);
}

std::vector<Phasor> phasors_of(const Spot& spot, const V2d& across, double radius_m)
{
    std::vector<Phasor> phasors;
    phasors.reserve(spot.points.size());
    for (const SpotPoint& point : spot.points) {
        phasors.push_back({.angle_deg = deg_from_rad(point.angle_rad.dot(across)),
                           .weight = point.weight,
                           .reach_m = reach(point.pupil_point_m, across, radius_m)});
    }
    return phasors;
}

// `shift_m_per_cpd` is the distance of the pupil's copies: 0 without diffraction.
std::vector<double> transfer(const Spot& spot,
                             double radius_m,
                             double shift_m_per_cpd,
                             double meridian_deg,
                             std::span<const double> frequencies_cpd)
{
    const double meridian_rad = rad_from_deg(meridian_deg);
    const V2d across(std::cos(meridian_rad), std::sin(meridian_rad));
    const std::vector<Phasor> phasors = phasors_of(spot, across, radius_m);
    std::vector<double> mtf;
    mtf.reserve(frequencies_cpd.size());
    for (const double frequency_cpd : frequencies_cpd) {
        const double shift_m = shift_m_per_cpd * frequency_cpd;
        std::complex<double> sum = 0.0;
        for (const Phasor& phasor : phasors) {
            if (shift_m <= phasor.reach_m) {
                sum += std::polar(phasor.weight, 2.0 * pi * frequency_cpd * phasor.angle_deg);
            }
        }
        mtf.push_back(spot.weight > 0.0 ? std::abs(sum) / spot.weight : 0.0);
    }
    return mtf;
}

}  // namespace

std::vector<double> geometric_mtf(const Spot& spot,
                                  double meridian_deg,
                                  std::span<const double> frequencies_cpd)
{
    // A pupil without an edge, so that rounding at the true one loses no ray.
    constexpr double radius_m = 1.0;
    return transfer(spot, radius_m, 0.0, meridian_deg, frequencies_cpd);
}

std::vector<double> wave_mtf(const Spot& spot,
                             const RoundPupil& pupil,
                             double meridian_deg,
                             std::span<const double> frequencies_cpd)
{
    // A frequency in cycles per radian is the copies' distance in wavelengths.
    const double shift_m_per_cpd = deg_from_rad(1.0) * pupil.wavelength_nm * 1e-9;
    return transfer(spot, 0.5 * pupil.diameter_m, shift_m_per_cpd, meridian_deg, frequencies_cpd);
}

}  // namespace eye_render
