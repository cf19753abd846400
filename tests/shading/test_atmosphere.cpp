#include "shading/sky/atmosphere.h"
#include "shading/sky/spectra.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

const V3d up(0.0, 0.0, 1.0);
const V3d east(1.0, 0.0, 0.0);

V3d transmitted(double depth_of_air_m)
{
    SkySpectra::Spectrum spectrum{};
    for (std::size_t i = 0; i < sky_wavelength_count; ++i) {
        spectrum[i] = sky_spectra().sunlight[i] *
                      std::exp(-depth_of_air_m * sky_spectra().rayleigh_per_m[i]);
    }
    return xyz_of(spectrum);
}

TEST(Atmosphere, sun_at_the_zenith_shines_through_one_scale_height_of_air)
{
    const double height_m = 8000.0 * (1.0 - std::exp(-60.0 / 8.0));
    const V3d expected = transmitted(height_m);
    const V3d made = Air({.air = 1.0, .dust = 0.0, .ozone = 0.0}, 0.0).sunlight_xyz(up);
    constexpr double quadrature = 2e-3;  // eight nodes
    EXPECT_LE((made - expected).length(), quadrature * expected.length()) << made << expected;
}

TEST(Atmosphere, sunlight_without_air_is_the_solar_constant_in_daylight)
{
    const V3d made = Air({.air = 0.0, .dust = 0.0, .ozone = 0.0}, 0.0).sunlight_xyz(up);
    EXPECT_LE((made - transmitted(0.0)).length(), 1e-9 * made.length());
    // 683 lm/W: about 130 klx above the air (the CIE's solar illuminance constant is 133.8 klx).
    constexpr double blackbody_for_sun = 8.5;
    EXPECT_NEAR(683.0 * made.y / 1000.0, 133.8, blackbody_for_sun);
}

TEST(Atmosphere, nothing_scatters_where_there_is_no_air)
{
    const Air none({.air = 0.0, .dust = 0.0, .ozone = 1.0}, 0.0);
    EXPECT_EQ(none.scattered_xyz(up, east), V3d(0.0));
}

TEST(Atmosphere, thin_air_scatters_in_proportion)
{
    const V3d sun = V3d(1.0, 0.0, 1.0).normalized();
    const V3d one = Air({.air = 1e-4, .dust = 0.0, .ozone = 0.0}, 0.0).scattered_xyz(up, sun);
    const V3d two = Air({.air = 2e-4, .dust = 0.0, .ozone = 0.0}, 0.0).scattered_xyz(up, sun);
    constexpr double scattered_again = 1e-3;
    EXPECT_LE((two - one * 2.0).length(), scattered_again * two.length());
}

TEST(Atmosphere, zenith_is_blue_and_the_low_sun_red)
{
    const Air clear({}, 0.0);
    const V3d sky = clear.scattered_xyz(up, V3d(1.0, 0.0, 1.0).normalized());
    EXPECT_GT(sky.z, sky.x);
    const V3d sunset = clear.sunlight_xyz(V3d(1.0, 0.0, 0.02).normalized());
    EXPECT_GT(sunset.x, 2.0 * sunset.z);
}

TEST(Atmosphere, is_dark_when_the_sun_is_far_below)
{
    const Air clear({}, 0.0);
    const double noon = clear.scattered_xyz(up, up).y;
    EXPECT_EQ(clear.scattered_xyz(up, V3d(0.6, 0.0, -0.8)).y, 0.0);
    EXPECT_GT(clear.scattered_xyz(up, V3d(1.0, 0.0, -0.03).normalized()).y, 0.0);
    EXPECT_LT(clear.scattered_xyz(up, V3d(1.0, 0.0, -0.03).normalized()).y, 0.1 * noon);
}

}  // namespace
}  // namespace eye_render
