// Vectors, matrices and colours: Imath's, under the names this project uses.
//
// Imath multiplies row vectors, p' = p * M; every matrix that enters from outside (Blender,
// NumPy) is written for column vectors and is transposed once, where it enters (api/).

#pragma once

#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

#include <algorithm>
#include <limits>

namespace eye_render {

using V2d = Imath::V2d;
using V3d = Imath::V3d;
using V2f = Imath::V2f;
using V3f = Imath::V3f;
using V3i = Imath::V3i;
using M33f = Imath::M33f;
using M44f = Imath::M44f;
using M44d = Imath::M44d;
using Color3f = Imath::Color3f;
using Color4f = Imath::Color4f;

// Rec. 709 luminance of a linear colour. Near enough in any working space to choose samples by;
// what is shown weighs channels by the scene's own (working_space.h).
[[nodiscard]] inline float luminance(const Color3f& c)
{
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

// `v` at length 1, or `otherwise` where it has no direction.
[[nodiscard]] inline V3f unit_or(const V3f& v, const V3f& otherwise)
{
    const float length = v.length();
    return length > 0.0f && length <= std::numeric_limits<float>::max() ? v / length : otherwise;
}

[[nodiscard]] inline float max_component(const Color3f& c)
{
    return std::max(c.x, std::max(c.y, c.z));
}

}  // namespace eye_render
