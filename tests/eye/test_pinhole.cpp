// The pinhole has no blur.

#include "eye/eye_factory.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(PinholeEye, every_pupil_point_gives_the_chief_ray)
{
    const auto eye = make_eye({.model = EyeModelKind::Pinhole,
                               .rx = Prescription{.sphere_d = -10.0},
                               .pupil_diameter_m = 6e-3});
    for (const V2d& pupil_point_m : {V2d(0.0, 0.0), V2d(3e-3, -1e-3)}) {
        const EyeRay ray = eye->ray({0.1, -0.2}, pupil_point_m, 555.0);
        EXPECT_EQ(ray.fate, RayFate::Transmitted);
        EXPECT_EQ(ray.origin_eye_m, V3d(0.0));
        EXPECT_EQ(ray.slope, V2d(0.1, -0.2));
        EXPECT_EQ(ray.weight, 1.0);
    }
    EXPECT_EQ(eye->pupil_diameter_m(), 0.0);
    EXPECT_EQ(eye->retinal_conjugate_d().xx_d, 0.0);
}

}  // namespace
}  // namespace eye_render
