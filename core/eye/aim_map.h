// A fitted map in place of the search for the ray from a point of the stop to a point of the
// retina.
//
// With the stop point s and the sines c, at the stop's centre, of the reference ray to that point
// of the retina, the ray's sines are
//     c + P s + Q c,  P and Q polynomials in c.c, s.c and s.s,
// because lens and retina are of revolution (Welford 1986, "Aberrations of Optical Systems",
// chapter 7, has the aberrations of such systems in the same variables). Away from the reference
// wavelength P and Q change by a polynomial in 1 / (wavelength - 130 nm), the variable of Cornu's
// dispersion formula.

#pragma once

#include "eye/monomials.h"
#include "optics/lens_system.h"

#include <optional>

namespace eye_render {

class AimMap {
public:
    // Of P and Q, of their change with wavelength, and how many powers of that variable. They keep
    // all three eyes, relaxed, below 0.005 arcmin over 40 degrees of field and a pupil of 6 mm;
    // one less in each triples that and saves a twentieth of a ray's time.
    static constexpr std::size_t degree = 6;
    static constexpr std::size_t chromatic_degree = 4;
    static constexpr std::size_t chromatic_powers = 5;

    // For stop points and reference sines up to these lengths, above 0. Nothing when a ray among
    // them is lost.
    [[nodiscard]] static std::optional<AimMap> fitted(const LensSystem& system,
                                                      double max_stop_m,
                                                      double max_chief_sine);

    [[nodiscard]] V2d operator()(const V2d& stop_point_m,
                                 const V2d& chief,
                                 double wavelength_nm) const;

private:
    // Of one monomial in P and Q.
    struct Term {
        double p = 0.0;
        double q = 0.0;
    };

    double per_stop_ = 1.0;
    double per_chief_ = 1.0;
    std::array<Term, monomials_of_three(degree)> reference_{};
    // The lowest power first, which is 1.
    std::array<std::array<Term, chromatic_powers>, monomials_of_three(chromatic_degree)>
        chromatic_{};
};

}  // namespace eye_render
