// Orthonormal basis around a unit vector: along a given tangent, or any, by Duff et al. 2017,
// "Building an Orthonormal Basis, Revisited" (JCGT 6(1)).

#pragma once

#include "base/vector.h"

#include <cmath>

namespace eye_render {

struct Frame {
    V3f s, t, n;

    explicit Frame(const V3f& normal) : n(normal)
    {
        const float sign = std::copysign(1.0f, n.z);
        const float a = -1.0f / (sign + n.z);
        const float b = n.x * n.y * a;
        s = {1.0f + sign * n.x * n.x * a, sign * b, -sign * n.x};
        t = {b, sign + n.y * n.y * a, -n.y};
    }

    // With s along a unit vector across the normal.
    Frame(const V3f& normal, const V3f& tangent) : s(tangent), t(normal.cross(tangent)), n(normal)
    {
    }

    [[nodiscard]] V3f world_from_local(const V3f& v) const { return s * v.x + t * v.y + n * v.z; }
    [[nodiscard]] V3f local_from_world(const V3f& v) const
    {
        return {v.dot(s), v.dot(t), v.dot(n)};
    }
};

}  // namespace eye_render
