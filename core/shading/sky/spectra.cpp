#include "shading/sky/spectra.h"

#include "base/units.h"
#include "shading/functions/cie_observer.h"

#include <cmath>

namespace eye_render {

namespace {

// Planck's law at the sun's temperature, times the solid angle of its disc.
[[nodiscard]] double sunlight(double wavelength_nm)
{
    constexpr double planck_j_s = 6.62607015e-34;
    constexpr double light_m_s = 299792458.0;
    constexpr double boltzmann_j_k = 1.380649e-23;
    constexpr double temperature_k = 5778.0;
    constexpr double solid_angle_sr = 6.79016e-5;
    const double wavelength_m = wavelength_nm * 1e-9;
    const double photon_j = planck_j_s * light_m_s / wavelength_m;
    const double radiance_per_m =
        2.0 * photon_j * light_m_s /
        (std::pow(wavelength_m, 4.0) * std::expm1(photon_j / (boltzmann_j_k * temperature_k)));
    return radiance_per_m * 1e-9 * solid_angle_sr;
}

// Rayleigh's law for air of that index and number of molecules.
[[nodiscard]] double rayleigh_per_m(double wavelength_nm)
{
    constexpr double index = 1.0002926;
    constexpr double molecules_per_m3 = 2.504e25;
    const double excess = index * index - 1.0;
    return 8.0 * std::pow(pi, 3.0) * excess * excess /
           (3.0 * molecules_per_m3 * std::pow(wavelength_nm * 1e-9, 4.0));
}

// The Chappuis and Huggins bands, 1e-9 per metre, as Blender's sky has them.
constexpr SkySpectra::Spectrum ozone_per_gm{
    3.25126849861,    5.85395365047,    19.77191155085,   73.09568762914,   200.84561514287,
    403.83958096161,  635.51335912363,  967.07041180970,  1547.97400424410, 2090.38647223331,
    2461.28056164565, 2735.51299461512, 2151.25862863128, 1590.51840791988, 1123.56197979857,
    735.27551487574,  464.50130357806,  330.96079921048,  225.12612292678,  148.79129266490,
    168.28623364192};

[[nodiscard]] SkySpectra computed()
{
    SkySpectra spectra{};
    for (std::size_t i = 0; i < sky_wavelength_count; ++i) {
        const double wavelength_nm = static_cast<double>(observer_first_nm) +
                                     static_cast<double>(i) * sky_wavelength_step_nm;
        spectra.sunlight[i] = sunlight(wavelength_nm);
        spectra.rayleigh_per_m[i] = rayleigh_per_m(wavelength_nm);
        spectra.ozone_per_m[i] = ozone_per_gm[i] * 1e-9;
        spectra.observer[i] = V3d(xyz_of_wavelength(static_cast<float>(wavelength_nm)));
    }
    return spectra;
}

}  // namespace

const SkySpectra& sky_spectra()
{
    static const SkySpectra spectra = computed();
    return spectra;
}

V3d xyz_of(const SkySpectra::Spectrum& spectrum)
{
    V3d xyz(0.0);
    for (std::size_t i = 0; i < sky_wavelength_count; ++i) {
        xyz += sky_spectra().observer[i] * spectrum[i];
    }
    return xyz * sky_wavelength_step_nm;
}

}  // namespace eye_render
