#include "shading/sky/hosek_wilkie_sky.h"

#include "base/units.h"
#include "shading/functions/color_adjust.h"
#include "shading/functions/vector_operations.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace eye_render {

namespace {

// A curve of Bezier at t, its control points `stride` apart.
[[nodiscard]] float bezier(const float* points, std::size_t stride, float t)
{
    constexpr std::array<float, HosekWilkieData::control_points> binomials{1, 5, 10, 10, 5, 1};
    float sum = 0.0f;
    for (std::size_t i = 0; i < binomials.size(); ++i) {
        const auto power = static_cast<float>(i);
        sum += binomials[i] * std::pow(1.0f - t, 5.0f - power) * std::pow(t, power) *
               points[i * stride];
    }
    return sum;
}

// One of `parameters` of a table, linear between turbidities and between albedos.
[[nodiscard]] float look_up(std::span<const float> table,
                            std::size_t parameters,
                            std::size_t parameter,
                            float turbidity,
                            float albedo,
                            float elevation)
{
    constexpr std::size_t turbidities = HosekWilkieData::turbidities;
    const std::size_t curve = HosekWilkieData::control_points * parameters;
    const auto below = std::min(static_cast<std::size_t>(turbidity), turbidities - 1);
    const float share = turbidity - static_cast<float>(below);
    const auto at = [&](std::size_t ground, std::size_t number) {
        return bezier(&table[(ground * turbidities + number - 1) * curve + parameter], parameters,
                      elevation);
    };
    const auto over = [&](std::size_t ground) {
        return at(ground, below) * (1.0f - share) + at(ground, below + 1) * share;
    };
    return over(0) * (1.0f - albedo) + over(1) * albedo;
}

}  // namespace

HosekWilkieSky::HosekWilkieSky(const V3f& sun,
                               float turbidity,
                               float ground_albedo,
                               WorkingSpace space)
    : space_(space), sun_(safe_normalized(sun))
{
    if (sun_.z < 0.0f) {
        sun_ = unit_or(V3f(sun_.x, sun_.y, 0.0f), V3f(0.0f, 1.0f, 0.0f));
    }
    const float elevation_rad = std::asin(std::clamp(sun_.z, 0.0f, 1.0f));
    const float elevation = std::cbrt(elevation_rad / (0.5f * static_cast<float>(pi)));
    const std::array data{&hosek_wilkie_x, &hosek_wilkie_y, &hosek_wilkie_z};
    for (std::size_t channel = 0; channel < data.size(); ++channel) {
        Channel& made = xyz_[channel];
        for (std::size_t i = 0; i < made.shape.size(); ++i) {
            made.shape[i] = look_up(data[channel]->shape, made.shape.size(), i, turbidity,
                                    ground_albedo, elevation);
        }
        made.mean = look_up(data[channel]->radiance, 1, 0, turbidity, ground_albedo, elevation);
    }
}

Color3f HosekWilkieSky::radiance(const V3f& direction) const
{
    // Below the horizon the sky goes on as it is there.
    constexpr float lowest_cosine = 0.001f;
    const float cos_theta = clamp_between(direction.z, lowest_cosine, 1.0f);
    const float cos_gamma = clamp_between(direction.dot(sun_), -1.0f, 1.0f);
    const float gamma = std::acos(cos_gamma);
    const auto value = [&](const Channel& channel) {
        // The data have the paper's H, which bends chi, last.
        const auto& [a, b, c, d, e, f, g, i, h] = channel.shape;
        const float chi =
            (1.0f + cos_gamma * cos_gamma) / std::pow(1.0f + h * h - 2.0f * h * cos_gamma, 1.5f);
        return channel.mean * (1.0f + a * std::exp(b / (cos_theta + 0.01f))) *
               (c + d * std::exp(e * gamma) + f * cos_gamma * cos_gamma + g * chi +
                i * std::sqrt(cos_theta));
    };
    // Blender's brightness: the data are luminances over 683 lm/W.
    constexpr float scale = 2.0f * static_cast<float>(pi) / 683.0f;
    return not_negative(rgb_from_xyz({value(xyz_[0]), value(xyz_[1]), value(xyz_[2])}, space_)) *
           scale;
}

}  // namespace eye_render
