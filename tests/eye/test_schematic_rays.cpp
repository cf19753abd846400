// The searches of the exact trace: what they find lands where it should.

#include "eye/schematic_rays.h"

#include "../optics/lens_systems.h"
#include "eye/schematic_body.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(SchematicRays, a_stop_of_4_mm_is_an_entrance_pupil_of_4_4916_mm)
{
    // Navarro's eye at 550 nm by real rays; 4.53 mm to first order.
    const LensSystem system = schematic_eye(SchematicEyeKind::Navarro, 0.0);
    const Sought rim_m = stop_point(system, indices_at(system, 550.0), {0.5 * 4.4916e-3, 0.0});
    ASSERT_EQ(rim_m.fate, TraceFate::Passed);
    EXPECT_NEAR(rim_m.value.x, 2e-3, 0.5e-7);
    EXPECT_EQ(rim_m.value.y, 0.0);
}

TEST(SchematicRays, the_chief_ray_leaves_the_eye_in_the_direction_asked_for)
{
    const LensSystem system = schematic_eye(SchematicEyeKind::Navarro, 0.0);
    const Indices indices = indices_at(system, reference_wavelength_nm);
    for (const V2d& object_sines :
         {V2d(0.0), V2d(0.3, -0.2), V2d(-0.7, 0.1), V2d(0.0, 0.95), V2d(1e-9, 0.0)}) {
        const Sought chief = chief_sines(system, indices, object_sines);
        ASSERT_EQ(chief.fate, TraceFate::Passed) << object_sines;
        const TraceResult out = object_ray(system, indices, V2d(0.0), chief.value);
        ASSERT_EQ(out.fate, TraceFate::Passed);
        EXPECT_NEAR(out.ray.direction.x, -object_sines.x, 1e-13);
        EXPECT_NEAR(out.ray.direction.y, -object_sines.y, 1e-13);
        EXPECT_LT(out.ray.direction.z, 0.0);
    }
}

// From the retina through the stop into the scene, and from there to the retina by the other
// trace: the same point, in round and toric eyes, on and off the axis, at any wavelength.
TEST(SchematicRays, come_back_from_the_scene_to_the_point_of_the_retina)
{
    for (const SchematicEyeKind kind :
         {SchematicEyeKind::Navarro, SchematicEyeKind::Arizona, SchematicEyeKind::LeGrand}) {
        const SchematicBody body =
            schematic_body({.kind = kind, .rx_entrance_pupil_d = {-4.0, 0.5, -1.0}});
        const LensSystem& system = body.system;
        const Indices reference = indices_at(system, reference_wavelength_nm);
        const Indices blue = indices_at(system, 450.0);
        for (const V2d& object_sines : {V2d(0.0), V2d(0.3, -0.2), V2d(-0.1, 0.5)}) {
            const Sought chief = chief_sines(system, reference, object_sines);
            ASSERT_EQ(chief.fate, TraceFate::Passed) << object_sines;
            const V3d retina_m =
                traced_to_retina(system, reference, stop_ray(system, V2d(0.0), chief.value),
                                 system.lens)
                    .ray.origin_m;
            for (const V2d& stop_m : {V2d(0.0), V2d(1.5e-3, 0.0), V2d(-1e-3, 1.7e-3)}) {
                const Sought sines = sines_to_retina(system, blue, stop_m, retina_m, chief.value);
                ASSERT_EQ(sines.fate, TraceFate::Passed) << object_sines << stop_m;
                const TraceResult out = object_ray(system, blue, stop_m, sines.value);
                ASSERT_EQ(out.fate, TraceFate::Passed) << object_sines << stop_m;
                const OpticalRay far = at_plane(out.ray, -20e-3);
                const TraceResult back =
                    traced_to_retina(system, blue, {far.origin_m, -far.direction});
                ASSERT_EQ(back.fate, TraceFate::Passed);
                EXPECT_NEAR((back.ray.origin_m - retina_m).length(), 0.0, 1e-12)
                    << object_sines << stop_m;
            }
        }
    }
}

}  // namespace
}  // namespace eye_render
