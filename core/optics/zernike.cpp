// Radial polynomials by their recurrence, sums of terms by complex harmonics.

#include "optics/zernike.h"

#include <cmath>
#include <cstdlib>

namespace eye_render {

namespace {

// Coefficients of |z|^2k, from k = 0, in R_n^m(|z|) / |z|^m. The highest is the binomial of n over
// (n - m) / 2 and each lower one follows from the ratio of neighbours, so no factorial overflows.
std::vector<double> radial_coefficients(int n, int m)
{
    const int highest = (n - m) / 2;
    double coefficient = 1.0;
    for (int i = 1; i <= highest; ++i) {
        coefficient = coefficient * static_cast<double>(n - highest + i) / i;
    }
    std::vector<double> coefficients(static_cast<std::size_t>(highest) + 1);
    for (int s = 0; s <= highest; ++s) {
        coefficients[static_cast<std::size_t>(highest - s)] = coefficient;
        // Products before quotients: every step is a whole number.
        coefficient *= -static_cast<double>((n - highest - s) * (highest - s));
        coefficient /= static_cast<double>((s + 1) * (n - s));
    }
    return coefficients;
}

struct ValueAndDerivative {
    std::complex<double> value;
    std::complex<double> derivative;
};

ValueAndDerivative horner(const std::vector<std::complex<double>>& coefficients, double t)
{
    ValueAndDerivative sum;
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        sum.derivative = sum.derivative * t + sum.value;
        sum.value = sum.value * t + coefficients[k];
    }
    return sum;
}

}  // namespace

double zernike_norm(const ZernikeTerm& term)
{
    return std::sqrt((term.m == 0 ? 1.0 : 2.0) * (term.n + 1));
}

double zernike_radial(int n, int m, double rho)
{
    if (n < m) return 0.0;
    double value = 0.0;
    const std::vector<double> coefficients = radial_coefficients(n, m);
    for (std::size_t k = coefficients.size(); k-- > 0;) {
        value = value * rho * rho + coefficients[k];
    }
    return value * std::pow(rho, m);
}

void PupilPolynomial::add(const ZernikeTerm& term, double coefficient)
{
    const int frequency = std::abs(term.m);
    const std::vector<double> radial = radial_coefficients(term.n, frequency);
    const auto m = static_cast<std::size_t>(frequency);
    harmonics_.resize(std::max(harmonics_.size(), m + 1));
    harmonics_[m].resize(std::max(harmonics_[m].size(), radial.size()));
    const std::complex<double> scale =
        coefficient * zernike_norm(term) *
        (term.m < 0 ? std::complex<double>(0.0, -1.0) : std::complex<double>(1.0, 0.0));
    for (std::size_t k = 0; k < radial.size(); ++k) {
        harmonics_[m][k] += scale * radial[k];
    }
}

void PupilPolynomial::drop_below(int degree)
{
    for (std::size_t m = 0; m < harmonics_.size(); ++m) {
        for (std::size_t k = 0; k < harmonics_[m].size(); ++k) {
            if (m + 2 * k < static_cast<std::size_t>(degree)) {
                harmonics_[m][k] = 0.0;
            }
        }
    }
}

PupilPolynomial::SecondDegree PupilPolynomial::second_degree() const
{
    const auto harmonic = [this](std::size_t m, std::size_t k) {
        return m < harmonics_.size() && k < harmonics_[m].size() ? harmonics_[m][k] : 0.0;
    };
    return {.round = harmonic(0, 1).real(),
            .straight = harmonic(2, 0).real(),
            .oblique = -harmonic(2, 0).imag()};
}

double PupilPolynomial::value(const V2d& p) const
{
    const std::complex<double> z(p.x, p.y);
    const double t = std::norm(z);
    std::complex<double> power = 1.0;
    double sum = 0.0;
    for (const auto& harmonic : harmonics_) {
        sum += (horner(harmonic, t).value * power).real();
        power *= z;
    }
    return sum;
}

V2d PupilPolynomial::gradient(const V2d& p) const
{
    // (d/dx + i d/dy) Re(A(|z|^2) z^m) = 2 z Re(A' z^m) + m conj(A z^(m-1)).
    const std::complex<double> z(p.x, p.y);
    const double t = std::norm(z);
    std::complex<double> power = 1.0;
    std::complex<double> lower_power = 0.0;
    std::complex<double> sum = 0.0;
    double m = 0.0;
    for (const auto& harmonic : harmonics_) {
        const auto [value, derivative] = horner(harmonic, t);
        sum += 2.0 * z * (derivative * power).real() + m * std::conj(value * lower_power);
        lower_power = power;
        power *= z;
        m += 1.0;
    }
    return {sum.real(), sum.imag()};
}

}  // namespace eye_render
