// Where a picture's point lies for a point of space, in the projections of Blender's Image and
// Environment Texture. u and v are 0 to 1 over the picture, v = 1 at its top.

#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

// The whole sphere by longitude and latitude; the centre is along +X.
[[nodiscard]] inline V2f uv_equirectangular(const V3f& d)
{
    if (d == V3f(0.0f)) {
        return V2f(0.0f);  // as Cycles
    }
    return {0.5f - std::atan2(d.y, d.x) * (0.5f * std::numbers::inv_pi_v<float>),
            0.5f + std::atan2(d.z, std::hypot(d.x, d.y)) * std::numbers::inv_pi_v<float>};
}

// A photograph of a mirroring ball; `d` is unit.
[[nodiscard]] inline V2f uv_on_mirror_ball(const V3f& d)
{
    const float length = 2.0f * std::sqrt(std::max(-0.5f * (d.y - 1.0f), 0.0f));
    const float scale = length > 0.0f ? 1.0f / length : 1.0f;
    return {0.5f * (d.x * scale + 1.0f), 0.5f * (d.z * scale + 1.0f)};
}

// Around a sphere and a tube in the box from 0 to 1.
[[nodiscard]] inline V2f uv_on_sphere(const V3f& p)
{
    const V3f d = (p - V3f(0.5f)) * 2.0f;
    const float length = d.length();
    if (!(length > 0.0f)) {
        return V2f(0.0f);
    }
    const float u = d.x == 0.0f && d.y == 0.0f
                        ? 0.0f
                        : 0.5f * (1.0f - std::atan2(d.x, d.y) * std::numbers::inv_pi_v<float>);
    return {u, 1.0f - std::acos(std::clamp(d.z / length, -1.0f, 1.0f)) *
                          std::numbers::inv_pi_v<float>};
}

[[nodiscard]] inline V2f uv_on_tube(const V3f& p)
{
    const V3f d = (p - V3f(0.5f)) * 2.0f;
    if (!(std::hypot(d.x, d.y) > 0.0f)) {
        return V2f(0.0f);
    }
    return {0.5f * (1.0f - std::atan2(d.x, d.y) * std::numbers::inv_pi_v<float>),
            0.5f * (d.z + 1.0f)};
}

// On the side of a box that looks along axis `side`, or against it: nothing is mirrored.
[[nodiscard]] inline V2f uv_on_box(const V3f& p, int side, bool is_negative)
{
    switch (side) {
    case 0: return {is_negative ? 1.0f - p.y : p.y, p.z};
    case 1: return {is_negative ? p.x : 1.0f - p.x, p.z};
    default: return {is_negative ? p.y : 1.0f - p.y, p.x};
    }
}

// How much of each of the three sides a normal sees: one of them, but near the edges, as wide as
// `blend` says, two or three.
[[nodiscard]] inline V3f box_weights(const V3f& normal, float blend)
{
    V3f n(std::abs(normal.x), std::abs(normal.y), std::abs(normal.z));
    n /= n.x + n.y + n.z;
    const float limit = 0.5f * (1.0f + blend);
    for (int side = 0; side < 3; ++side) {
        const float a = n[(side + 1) % 3];
        const float b = n[(side + 2) % 3];
        if (n[side] > limit * (n[side] + a) && n[side] > limit * (n[side] + b)) {
            V3f one(0.0f);
            one[side] = 1.0f;
            return one;
        }
    }
    if (!(blend > 0.0f)) {
        return {1.0f, 0.0f, 0.0f};  // on an edge, or NaN
    }
    for (int third = 0; third < 3; ++third) {
        const int first = third == 0 ? 1 : 0;
        const int second = 3 - third - first;
        if (n[third] < (1.0f - limit) * (n[first] + n[second])) {
            const float share = n[first] / (n[first] + n[second]);
            V3f two(0.0f);
            two[first] = std::clamp((share - 0.5f * (1.0f - blend)) / blend, 0.0f, 1.0f);
            two[second] = 1.0f - two[first];
            return two;
        }
    }
    return ((2.0f - limit) * n + V3f(limit - 1.0f)) / (2.0f * limit - 1.0f);
}

}  // namespace eye_render
