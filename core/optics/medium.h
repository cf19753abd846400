// Refractive index as a function of wavelength, by the formulas that the schematic eyes were
// published with.

#pragma once

#include <variant>

namespace eye_render {

struct ConstantIndex {
    double n = 1.0;
};

// Cornu's formula as Le Grand uses it: n = n_infinity + k / (wavelength - 130 nm).
struct CornuDispersion {
    double n_infinity = 1.0;
    double k_nm = 0.0;
};

// Herzberger's formula in the form of Navarro, Santamaria & Bescos 1985 (eq. 4 and table 4): the
// index is interpolated between those at 365 nm (n**), the lines F and C, and 1014 nm (n*).
struct HerzbergerDispersion {
    double n_365 = 1.0;
    double n_f = 1.0;
    double n_c = 1.0;
    double n_1014 = 1.0;
};

// Cauchy's formula with two terms, n = a + b / wavelength^2.
struct CauchyDispersion {
    double a = 1.0;
    double b_nm2 = 0.0;
};

using Medium =
    std::variant<ConstantIndex, CornuDispersion, HerzbergerDispersion, CauchyDispersion>;

// The two terms that give the index at the line d (587.6 nm) and Abbe's number
// V = (n_d - 1) / (n_F - n_C) exactly.
[[nodiscard]] CauchyDispersion cauchy_from_abbe(double n_d, double abbe_number);

// For visible wavelengths; the formulas have poles below 170 nm.
[[nodiscard]] double refractive_index(const Medium& medium, double wavelength_nm);

}  // namespace eye_render
