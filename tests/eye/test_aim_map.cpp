// The fitted aim against the search that it replaces.

#include "eye/aim_map.h"

#include "eye/schematic_rays.h"
#include "optics/chromatic.h"
#include "optics/schematic_eyes.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

constexpr double max_stop_m = 2.7e-3;
constexpr double max_chief_sine = 0.3;

TEST(AimMap, sends_rays_where_the_search_does_in_every_direction)
{
    for (const SchematicEyeKind kind :
         {SchematicEyeKind::Navarro, SchematicEyeKind::Arizona, SchematicEyeKind::LeGrand}) {
        const LensSystem system = schematic_eye(kind, 0.0);
        const auto aim = AimMap::fitted(system, max_stop_m, max_chief_sine);
        ASSERT_TRUE(aim.has_value());
        const Indices reference = indices_at(system, reference_wavelength_nm);
        for (const double wavelength_nm : {380.0, 430.0, 500.0, 555.0, 620.0, 780.0}) {
            const Indices indices = indices_at(system, wavelength_nm);
            for (const V2d& chief : {V2d(0.0), V2d(0.2, 0.0), V2d(-0.1, 0.25), V2d(0.05, -0.28)}) {
                const V3d retina_m =
                    traced_to_retina(system, reference, stop_ray(system, V2d(0.0), chief),
                                     system.lens)
                        .ray.origin_m;
                for (const V2d& stop_m : {V2d(0.0), V2d(2.6e-3, 0.0), V2d(-1.2e-3, 1.9e-3)}) {
                    const Sought sought =
                        sines_to_retina(system, indices, stop_m, retina_m, chief);
                    ASSERT_EQ(sought.fate, TraceFate::Passed);
                    // 0.02 arcmin is 5.8e-6 rad outside the eye.
                    EXPECT_NEAR(((*aim)(stop_m, chief, wavelength_nm) - sought.value).length(),
                                0.0, 1.5e-6)
                        << chief << stop_m << wavelength_nm;
                }
            }
        }
    }
}

TEST(AimMap, keeps_the_reference_ray_through_the_centre_of_the_stop)
{
    const auto aim =
        AimMap::fitted(schematic_eye(SchematicEyeKind::Navarro, 0.0), max_stop_m, max_chief_sine);
    ASSERT_TRUE(aim.has_value());
    const V2d chief(0.2, -0.1);
    EXPECT_NEAR(((*aim)(V2d(0.0), chief, reference_wavelength_nm) - chief).length(), 0.0, 1e-8);
}

TEST(AimMap, is_not_made_of_lost_rays)
{
    LensSystem system = schematic_eye(SchematicEyeKind::Navarro, 0.0);
    system.surfaces.back().semi_aperture_m = 2e-3;
    EXPECT_FALSE(AimMap::fitted(system, max_stop_m, max_chief_sine).has_value());
    EXPECT_TRUE(AimMap::fitted(system, 1e-3, 0.1).has_value());
}

}  // namespace
}  // namespace eye_render
