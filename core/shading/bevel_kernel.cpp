#include "shading/bevel_kernel.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

}  // namespace

float bevel_falloff(float distance, float radius)
{
    const float rest = 1.0f - distance / radius;
    return rest > 0.0f ? 10.0f * rest * rest * rest / (pi * radius * radius) : 0.0f;
}

float sample_bevel_distance(float u)
{
    // The share within r is 10 r^2 - 20 r^3 + 15 r^4 - 4 r^5, which rises from 0 to 1: Newton's
    // steps, kept between the bounds that are known by then.
    float low = 0.0f;
    float high = 1.0f;
    float r = 0.25f;
    constexpr int most_steps = 24;
    constexpr float tolerance = 1e-6f;
    for (int i = 0; i < most_steps; ++i) {
        const float excess = r * r * (10.0f + r * (-20.0f + r * (15.0f - 4.0f * r))) - u;
        if (std::abs(excess) < tolerance) {
            break;
        }
        (excess > 0.0f ? high : low) = r;
        const float slope = 20.0f * r * (1.0f - r) * (1.0f - r) * (1.0f - r);
        const float next = r - excess / slope;
        // A flat slope, whose step is not finite, falls to the middle too.
        r = next > low && next < high ? next : 0.5f * (low + high);
    }
    return r;
}

BevelRay sample_bevel_ray(const V3f& ng, float radius, float u_axis, const V2f& u)
{
    const float distance = sample_bevel_distance(u.y) * radius;
    return {make_disk_ray(ng, distance, radius, u_axis, u.x), bevel_falloff(distance, radius)};
}

float bevel_weight(const BevelRay& bevel, float radius, const V3f& ng, float distance)
{
    return bevel.disk_pdf > 0.0f
               ? axis_weight(bevel.ray, ng) * bevel_falloff(distance, radius) / bevel.disk_pdf
               : 0.0f;
}

}  // namespace eye_render
