#include "shading/functions/spectral_colors.h"

#include "shading/functions/cie_observer.h"
#include "shading/functions/color_adjust.h"

#include <cmath>

namespace eye_render {

Color3f rgb_of_wavelength(float wavelength_nm, WorkingSpace space)
{
    constexpr float largest_channel = 2.52f;  // Rec. 709's red near 605 nm, as Blender rounds it
    return not_negative(rgb_from_xyz(xyz_of_wavelength(wavelength_nm), space) / largest_channel);
}

Color3f rgb_of_blackbody(float temperature_k, WorkingSpace space)
{
    constexpr float coldest_k = 800.0f;
    constexpr float hottest_k = 12000.0f;
    constexpr double second_radiation_constant_nm_k = 1.438776877e7;
    if (std::isnan(temperature_k)) {
        return Color3f(0.0f);
    }
    const double t = clamp_between(temperature_k, coldest_k, hottest_k);

    V3f xyz(0.0f);
    for (int i = 0; i < observer_count; ++i) {
        const double wavelength_nm =
            static_cast<double>(observer_first_nm) + i * static_cast<double>(observer_step_nm);
        // Relative to 560 nm, so that floats hold it at every temperature.
        const double radiance = std::pow(560.0 / wavelength_nm, 5.0) *
                                std::expm1(second_radiation_constant_nm_k / (560.0 * t)) /
                                std::expm1(second_radiation_constant_nm_k / (wavelength_nm * t));
        xyz += xyz_of_wavelength(static_cast<float>(wavelength_nm)) * static_cast<float>(radiance);
    }
    return not_negative(rgb_from_xyz(xyz / xyz.y, space));
}

}  // namespace eye_render
