#include "shading/frame.h"

#include <gtest/gtest.h>

namespace eye_render {
namespace {

TEST(Frame, is_orthonormal_and_right_handed_around_any_normal)
{
    constexpr float tolerance = 1e-6f;  // a few roundings of unit numbers
    const V3f normals[] = {{0, 0, 1},
                           {0, 0, -1},
                           {1, 0, 0},
                           {0, -1, 0},
                           {0.6f, 0.0f, -0.8f},
                           {0.48f, -0.6f, 0.64f},
                           {0.48f, -0.6f, -0.64f},
                           {1e-4f, 0.0f, -1.0f}};
    for (const V3f& normal : normals) {
        const V3f n = normal.normalized();
        const Frame frame(n);
        EXPECT_NEAR(frame.s.length(), 1.0f, tolerance) << n;
        EXPECT_NEAR(frame.s.dot(frame.n), 0.0f, tolerance) << n;
        EXPECT_LT((frame.s.cross(frame.t) - n).length(), tolerance) << n;
        const V3f v(0.3f, -0.5f, 0.7f);
        EXPECT_LT((frame.local_from_world(frame.world_from_local(v)) - v).length(), tolerance)
            << n;
    }
}

}  // namespace
}  // namespace eye_render
