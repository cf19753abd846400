// Sampling warps: maps from the unit square [0, 1)^2 to the shapes light transport samples.
//
// Each is a set: sample_x (square to shape), x_pdf (density of the sample in the measure that its
// comment names) and invert_x (shape back to square), where one exists. All rest on the concentric
// map of Shirley & Chiu 1997, which keeps strata compact, so a well spread square gives a well
// spread shape. Directions are unit vectors in a local frame whose pole is +Z.

#pragma once

#include "base/vector.h"

#include <cmath>
#include <numbers>

namespace eye_render {

// Unit disk, density per unit area.
[[nodiscard]] inline V2f sample_uniform_disk(const V2f& u)
{
    constexpr float quarter_pi = std::numbers::pi_v<float> / 4.0f;
    const float a = 2.0f * u.x - 1.0f;
    const float b = 2.0f * u.y - 1.0f;
    if (a == 0.0f && b == 0.0f) {
        return V2f(0.0f);
    }
    if (std::abs(a) > std::abs(b)) {
        const float phi = quarter_pi * (b / a);
        return {a * std::cos(phi), a * std::sin(phi)};
    }
    const float phi = quarter_pi * (a / b);
    return {b * std::sin(phi), b * std::cos(phi)};
}

[[nodiscard]] constexpr float uniform_disk_pdf() { return std::numbers::inv_pi_v<float>; }

[[nodiscard]] inline V2f invert_uniform_disk(const V2f& p)
{
    constexpr float four_over_pi = 4.0f * std::numbers::inv_pi_v<float>;
    const float radius = std::hypot(p.x, p.y);
    if (radius == 0.0f) {
        return {0.5f, 0.5f};
    }
    float a = 0.0f;
    float b = 0.0f;
    if (std::abs(p.x) > std::abs(p.y)) {
        a = std::copysign(radius, p.x);
        b = a * four_over_pi * std::atan(p.y / p.x);
    } else {
        b = std::copysign(radius, p.y);
        a = b * four_over_pi * std::atan(p.x / p.y);
    }
    return {0.5f * (a + 1.0f), 0.5f * (b + 1.0f)};
}

// Cone around +Z, density per unit solid angle. The cone is given by 1 - cos(half angle), 0 to 2,
// because the cosine itself cannot tell a float the sun's disk (1e-5) from a point.
[[nodiscard]] inline V3f sample_uniform_cone(const V2f& u, float one_minus_cos)
{
    const V2f p = sample_uniform_disk(u);
    const float height = p.dot(p) * one_minus_cos;  // 1 - cos(theta)
    const float stretch = std::sqrt(one_minus_cos * std::max(0.0f, 2.0f - height));
    return {p.x * stretch, p.y * stretch, 1.0f - height};
}

// Infinite for a cone without width, which is a delta distribution.
[[nodiscard]] inline float uniform_cone_pdf(float one_minus_cos)
{
    return 0.5f * std::numbers::inv_pi_v<float> / one_minus_cos;
}

// `direction` lies in the cone, and the cone is wider than nothing.
[[nodiscard]] inline V2f invert_uniform_cone(const V3f& direction, float one_minus_cos)
{
    const float sin2 = direction.x * direction.x + direction.y * direction.y;
    if (sin2 == 0.0f && direction.z > 0.0f) {
        return {0.5f, 0.5f};
    }
    // 1 - z, without its cancellation near the pole.
    const float height = direction.z > 0.0f ? sin2 / (1.0f + direction.z) : 1.0f - direction.z;
    const float radius = std::min(1.0f, std::sqrt(height / one_minus_cos));
    const float scale = sin2 > 0.0f ? radius / std::sqrt(sin2) : 0.0f;
    return invert_uniform_disk(sin2 > 0.0f ? V2f(direction.x * scale, direction.y * scale)
                                           : V2f(radius, 0.0f));
}

// The whole sphere, density per unit solid angle: the cone whose half angle is 180 degrees.
[[nodiscard]] inline V3f sample_uniform_sphere(const V2f& u)
{
    return sample_uniform_cone(u, 2.0f);
}

[[nodiscard]] constexpr float uniform_sphere_pdf()
{
    return 0.25f * std::numbers::inv_pi_v<float>;
}

[[nodiscard]] inline V2f invert_uniform_sphere(const V3f& direction)
{
    return invert_uniform_cone(direction, 2.0f);
}

// Hemisphere around +Z, density per unit solid angle proportional to z. z may be 0 by rounding,
// and then so is the density.
[[nodiscard]] inline V3f sample_cosine_hemisphere(const V2f& u)
{
    const V2f p = sample_uniform_disk(u);
    return {p.x, p.y, std::sqrt(std::max(0.0f, 1.0f - p.dot(p)))};
}

[[nodiscard]] inline float cosine_hemisphere_pdf(float cos_theta)
{
    return std::max(0.0f, cos_theta) * std::numbers::inv_pi_v<float>;
}

[[nodiscard]] inline V2f invert_cosine_hemisphere(const V3f& direction)
{
    return invert_uniform_disk({direction.x, direction.y});
}

// Triangle: the barycentric weights of the first two corners, uniform per unit area, by the
// low-distortion map of Heitz 2019. The density is per unit of the (b0, b1) plane; divide it by
// twice the triangle's area for one per unit area.
[[nodiscard]] inline V2f sample_uniform_triangle(const V2f& u)
{
    if (u.y > u.x) {
        const float b0 = 0.5f * u.x;
        return {b0, u.y - b0};
    }
    const float b1 = 0.5f * u.y;
    return {u.x - b1, b1};
}

[[nodiscard]] constexpr float uniform_triangle_pdf() { return 2.0f; }

[[nodiscard]] inline V2f invert_uniform_triangle(const V2f& barycentrics)
{
    if (barycentrics.y > barycentrics.x) {
        return {2.0f * barycentrics.x, barycentrics.x + barycentrics.y};
    }
    return {barycentrics.x + barycentrics.y, 2.0f * barycentrics.y};
}

}  // namespace eye_render
