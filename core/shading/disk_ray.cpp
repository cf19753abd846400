#include "shading/disk_ray.h"

#include "shading/frame.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

DiskRay make_disk_ray(const V3f& ng, float distance, float radius, float u_axis, float u_around)
{
    const Frame frame(ng);
    DiskRay ray{.start{},
                .direction{},
                .axes = {frame.n, frame.s, frame.t},
                .axis_shares = {0.5f, 0.25f, 0.25f}};
    if (u_axis >= 0.5f) {
        const std::size_t first = u_axis < 0.75f ? 1 : 2;
        std::swap(ray.axes[0], ray.axes[first]);
        std::swap(ray.axis_shares[0], ray.axis_shares[first]);
    }
    const float phi = 2.0f * std::numbers::pi_v<float> * u_around;
    const float height = std::sqrt(std::max(0.0f, radius * radius - distance * distance));
    ray.start = ray.axes[0] * height + ray.axes[1] * (distance * std::cos(phi)) +
                ray.axes[2] * (distance * std::sin(phi));
    ray.direction = -ray.axes[0];
    ray.length = 2.0f * height;
    return ray;
}

float axis_weight(const DiskRay& ray, const V3f& ng)
{
    float squares = 0.0f;
    std::array<float, 3> densities{};
    for (std::size_t i = 0; i < 3; ++i) {
        densities[i] = ray.axis_shares[i] * std::abs(ray.axes[i].dot(ng));
        squares += densities[i] * densities[i];
    }
    return squares > 0.0f ? densities[0] / squares : 0.0f;
}

}  // namespace eye_render
