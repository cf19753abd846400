#include "shading/bevel_kernel.h"

#include "shading/frame.h"

#include <algorithm>
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
    const Frame frame(ng);
    BevelRay ray{.start{},
                 .direction{},
                 .axes = {frame.n, frame.s, frame.t},
                 .axis_shares = {0.5f, 0.25f, 0.25f}};
    if (u_axis >= 0.5f) {
        const std::size_t first = u_axis < 0.75f ? 1 : 2;
        std::swap(ray.axes[0], ray.axes[first]);
        std::swap(ray.axis_shares[0], ray.axis_shares[first]);
    }
    const float share = sample_bevel_distance(u.y);
    const float r = share * radius;
    const float phi = 2.0f * pi * u.x;
    const float height = radius * std::sqrt(std::max(0.0f, 1.0f - share * share));
    ray.start = ray.axes[0] * height + ray.axes[1] * (r * std::cos(phi)) +
                ray.axes[2] * (r * std::sin(phi));
    ray.direction = -ray.axes[0];
    ray.length = 2.0f * height;
    ray.disk_pdf = bevel_falloff(r, radius);
    return ray;
}

float bevel_weight(const BevelRay& ray, float radius, const V3f& ng, float distance)
{
    if (!(ray.disk_pdf > 0.0f)) {
        return 0.0f;
    }
    float squares = 0.0f;
    std::array<float, 3> densities{};
    for (std::size_t i = 0; i < 3; ++i) {
        densities[i] = ray.axis_shares[i] * std::abs(ray.axes[i].dot(ng));
        squares += densities[i] * densities[i];
    }
    return squares > 0.0f ? densities[0] / squares * bevel_falloff(distance, radius) / ray.disk_pdf
                          : 0.0f;
}

}  // namespace eye_render
