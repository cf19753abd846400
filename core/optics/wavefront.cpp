// Checks and conversions of Zernike coefficients.

#include "optics/wavefront.h"

#include "base/error.h"
#include "base/units.h"

#include <cmath>

namespace eye_render {

namespace {

// Index of the first term that a spectacle lens has no part in.
constexpr std::size_t first_higher_order = 6;

// What is odd in x: cos(m theta) for odd m, sin(m theta) for even m.
bool is_odd_in_x(const ZernikeTerm& term) { return (term.m % 2 != 0) == (term.m >= 0); }

}  // namespace

void require_valid(const Wavefront& wavefront)
{
    if (wavefront.coefficients_um.size() > max_zernike_terms) {
        throw std::invalid_argument(
            "the wavefront has " + std::to_string(wavefront.coefficients_um.size()) +
            " coefficients; expected up to " + std::to_string(max_zernike_terms) +
            ", the OSA indices 0 to 27");
    }
    for (std::size_t j = 0; j < wavefront.coefficients_um.size(); ++j) {
        require_range("wavefront coefficient " + std::to_string(j), wavefront.coefficients_um[j],
                      -max_zernike_um, max_zernike_um, "um");
    }
    require_range("wavefront pupil_mm", mm_from_m(wavefront.pupil_diameter_m),
                  mm_from_m(min_wavefront_pupil_m), mm_from_m(max_wavefront_pupil_m), "mm");
    require_range("wavefront wavelength_nm", wavefront.wavelength_nm, min_wavelength_nm,
                  max_infrared_nm, "nm");
}

void require_covers(const Wavefront& wavefront, double pupil_diameter_m)
{
    // Six digits are what a number keeps that was once written down.
    constexpr double rounding = 1.0 + 1e-6;
    if (pupil_diameter_m > wavefront.pupil_diameter_m * rounding) {
        throw std::invalid_argument("pupil_mm is " + number_text(mm_from_m(pupil_diameter_m)) +
                                    " mm; expected at most the wavefront's " +
                                    number_text(mm_from_m(wavefront.pupil_diameter_m)) + " mm");
    }
}

Wavefront mirrored(const Wavefront& wavefront)
{
    Wavefront result = wavefront;
    for (std::size_t j = 0; j < result.coefficients_um.size(); ++j) {
        if (is_odd_in_x(osa_term(static_cast<int>(j)))) {
            result.coefficients_um[j] = -result.coefficients_um[j];
        }
    }
    return result;
}

Wavefront rescaled(const Wavefront& wavefront, double pupil_diameter_m)
{
    require_range("pupil_mm", mm_from_m(pupil_diameter_m), mm_from_m(min_wavefront_pupil_m),
                  mm_from_m(max_wavefront_pupil_m), "mm");
    require_covers(wavefront, pupil_diameter_m);
    const double ratio = pupil_diameter_m / wavefront.pupil_diameter_m;
    Wavefront result = wavefront;
    result.pupil_diameter_m = pupil_diameter_m;
    const auto count = static_cast<int>(wavefront.coefficients_um.size());
    for (int j = 0; j < count; ++j) {
        const ZernikeTerm to = osa_term(j);
        double sum = 0.0;
        for (int n = to.n; osa_index({n, to.m}) < count; n += 2) {
            const double share =
                zernike_radial(n, to.n, ratio) - zernike_radial(n, to.n + 2, ratio);
            sum += wavefront.coefficients_um[static_cast<std::size_t>(osa_index({n, to.m}))] *
                   std::sqrt((n + 1.0) / (to.n + 1.0)) * share;
        }
        result.coefficients_um[static_cast<std::size_t>(j)] = sum;
    }
    return result;
}

double higher_order_rms_um(const Wavefront& wavefront)
{
    double sum_um2 = 0.0;
    for (std::size_t j = first_higher_order; j < wavefront.coefficients_um.size(); ++j) {
        sum_um2 += wavefront.coefficients_um[j] * wavefront.coefficients_um[j];
    }
    return std::sqrt(sum_um2);
}

PupilPolynomial polynomial_um(const Wavefront& wavefront)
{
    PupilPolynomial sum;
    for (std::size_t j = 0; j < wavefront.coefficients_um.size(); ++j) {
        if (wavefront.coefficients_um[j] != 0.0) {
            sum.add(osa_term(static_cast<int>(j)), wavefront.coefficients_um[j]);
        }
    }
    return sum;
}

// Both ways: the lens of power F flattens W = -1/2 p' F p, p in metres. Micrometres over square
// millimetres are dioptres.

Wavefront wavefront_corrected_by(const PowerVector& rx, double pupil_diameter_m)
{
    const double radius_mm = mm_from_m(0.5 * pupil_diameter_m);
    const double r2 = radius_mm * radius_mm;
    const double round = -rx.m_d * r2 / (4.0 * std::sqrt(3.0));
    const double straight = -rx.j0_d * r2 / (2.0 * std::sqrt(6.0));
    const double oblique = -rx.j45_d * r2 / (2.0 * std::sqrt(6.0));
    return {.coefficients_um = {0.0, 0.0, 0.0, oblique, round, straight},
            .pupil_diameter_m = pupil_diameter_m};
}

PowerVector paraxial_refraction(const Wavefront& wavefront)
{
    const double radius_mm = mm_from_m(0.5 * wavefront.pupil_diameter_m);
    const PupilPolynomial::SecondDegree w = polynomial_um(wavefront).second_degree();
    const double d_per_um = -2.0 / (radius_mm * radius_mm);
    return {w.round * d_per_um - chromatic_difference_d(wavefront.wavelength_nm),
            w.straight * d_per_um, w.oblique * d_per_um};
}

}  // namespace eye_render
