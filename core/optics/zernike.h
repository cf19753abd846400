// Zernike circle polynomials in the OSA/ANSI standard's numbering, sign and normalisation.
//
// Thibos, Applegate, Schwiegerling & Webb 2002, "Standards for reporting the optical aberrations
// of eyes" (J. Refract. Surg. 18); ANSI Z80.28. Z_n^m = N R_n^|m|(rho) cos(m theta) for m >= 0 and
// N R_n^|m|(rho) sin(|m| theta) below, N^2 = 2 (n + 1) / (1 + delta_m0), so that the mean of Z^2
// over the pupil is 1. Points are in units of the pupil's radius, theta runs counter-clockwise
// from +x, and the frame is the caller's. Noll's, Malacara's and the Fringe numbering differ.

#pragma once

#include "base/vector.h"

#include <complex>
#include <vector>

namespace eye_render {

// Radial order n and meridional frequency m: n >= |m|, n - |m| even.
struct ZernikeTerm {
    int n = 0;
    int m = 0;

    [[nodiscard]] constexpr bool operator==(const ZernikeTerm&) const = default;
};

// The single index j = (n (n + 2) + m) / 2: 0 piston, 1 and 2 tilt, 3 to 5 the second order.
[[nodiscard]] constexpr int osa_index(const ZernikeTerm& term)
{
    return (term.n * (term.n + 2) + term.m) / 2;
}

// The inverse, for index >= 0.
[[nodiscard]] constexpr ZernikeTerm osa_term(int index)
{
    int n = 0;
    while ((n + 1) * (n + 2) / 2 <= index) ++n;
    return {n, 2 * index - n * (n + 2)};
}

// N of the normalisation.
[[nodiscard]] double zernike_norm(const ZernikeTerm& term);

// R_n^m(rho), 1 at rho = 1; 0 when n < m, which no polynomial is.
[[nodiscard]] double zernike_radial(int n, int m, double rho);

// A sum of Zernike terms as a polynomial of x and y, which has a gradient at the centre, too.
class PupilPolynomial {
public:
    // Adds `coefficient` times Z_n^m.
    void add(const ZernikeTerm& term, double coefficient);

    // Leaves out all powers x^a y^b with a + b below `degree`: the Taylor polynomial at the
    // centre.
    void drop_below(int degree);

    // The coefficient of x^2 + y^2, of x^2 - y^2 and of 2 x y.
    struct SecondDegree {
        double round = 0.0;
        double straight = 0.0;
        double oblique = 0.0;
    };
    [[nodiscard]] SecondDegree second_degree() const;

    [[nodiscard]] double value(const V2d& p) const;
    [[nodiscard]] V2d gradient(const V2d& p) const;  // per radius of the pupil

private:
    // With z = x + i y the polynomial is the real part of the sum over m of A_m(|z|^2) z^m:
    // harmonics_[m][k] is the coefficient of |z|^2k in A_m, cosine terms in the real part and
    // minus the sine terms in the imaginary one.
    std::vector<std::vector<std::complex<double>>> harmonics_;
};

}  // namespace eye_render
