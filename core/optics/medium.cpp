#include "optics/medium.h"

#include <array>

namespace eye_render {

namespace {

double index_of(const ConstantIndex& medium, double /*wavelength_nm*/) { return medium.n; }

double index_of(const CornuDispersion& medium, double wavelength_nm)
{
    return medium.n_infinity + medium.k_nm / (wavelength_nm - 130.0);
}

double index_of(const CauchyDispersion& medium, double wavelength_nm)
{
    return medium.a + medium.b_nm2 / (wavelength_nm * wavelength_nm);
}

double index_of(const HerzbergerDispersion& medium, double wavelength_nm)
{
    // a = A0 + A1 l^2 + P / (l^2 - 0.028) + R / (l^2 - 0.028)^2 with l in micrometres. The A1 of
    // n** is printed a tenth as large in 1985; with this value the four weights add up to 1 at
    // every wavelength.
    struct Weight {
        double a0, a1, p, r;
    };
    constexpr std::array<Weight, 4> weights{{
        {0.66147196, -0.40352796, -0.28046790, 0.03385979},
        {-4.20146383, 2.73508956, 1.50543784, -0.11593235},
        {6.29834237, -4.69409935, -1.57508650, 0.10293038},
        {-1.75835059, 2.36253794, 0.35011657, -0.02085782},
    }};
    const double square_um2 = wavelength_nm * wavelength_nm * 1e-6;
    const double pole = 1.0 / (square_um2 - 0.028);
    const auto weight = [&](const Weight& w) {
        return w.a0 + w.a1 * square_um2 + pole * (w.p + pole * w.r);
    };
    return medium.n_365 * weight(weights[0]) + medium.n_f * weight(weights[1]) +
           medium.n_c * weight(weights[2]) + medium.n_1014 * weight(weights[3]);
}

}  // namespace

CauchyDispersion cauchy_from_abbe(double n_d, double abbe_number)
{
    constexpr double d_nm = 587.5618;
    constexpr double f_nm = 486.1327;
    constexpr double c_nm = 656.2725;
    const double b_nm2 = (n_d - 1.0) / abbe_number / (1.0 / (f_nm * f_nm) - 1.0 / (c_nm * c_nm));
    return {.a = n_d - b_nm2 / (d_nm * d_nm), .b_nm2 = b_nm2};
}

double refractive_index(const Medium& medium, double wavelength_nm)
{
    return std::visit([&](const auto& kind) { return index_of(kind, wavelength_nm); }, medium);
}

}  // namespace eye_render
