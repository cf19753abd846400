#include "scene/ray.h"

#include <gtest/gtest.h>

#include <cmath>

namespace eye_render {
namespace {

TEST(Ray, offset_leaves_the_surface_at_every_distance_from_the_eye)
{
    const V3f n = V3f(0.3f, -0.8f, 0.52f).normalized();
    for (const float distance : {1e-6f, 1e-3f, 1.0f, 1e3f, 1e7f}) {
        const V3f p(distance, -distance, 0.5f * distance);
        const V3f moved = offset_from_surface(p, n, 0.0f) - p;
        EXPECT_GT(moved.dot(n), 0.0f) << distance;
        // A few float steps of the coordinate.
        EXPECT_LT(moved.length(), 1e-6f * distance) << distance;
    }
}

TEST(Ray, offset_clears_the_error_that_the_point_may_have)
{
    const V3f p(1000.0f, 0.0f, 0.0f);
    EXPECT_GT((offset_from_surface(p, V3f(0, 0, 1), 0.25f) - p).z, 0.25f);
}

TEST(Ray, offset_is_the_same_on_both_sides)
{
    const V3f p(3.0f, -70.0f, 0.01f);
    const V3f n(0.0f, 0.6f, 0.8f);
    const V3f out = offset_from_surface(p, n, 0.0f) - p;
    const V3f in = offset_from_surface(p, -n, 0.0f) - p;
    EXPECT_NEAR(out.y, -in.y, 1e-6f * 70.0f);
    EXPECT_NEAR(out.z, -in.z, 1e-6f);
}

}  // namespace
}  // namespace eye_render
