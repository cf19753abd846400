#include "scene/ray.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

V3f offset_from_surface(const V3f& p, const V3f& n, float error)
{
    // The sum's own roundings: half a float step in each of three coordinates, and of the next
    // query, which takes the point from the corners it knows.
    constexpr float roundings = 4.0f * std::numeric_limits<float>::epsilon();
    const float largest = std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    return p + n * (error + roundings * largest);
}

}  // namespace eye_render
