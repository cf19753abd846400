#include "shading/sky/preetham_sky.h"

#include "base/units.h"
#include "shading/functions/color_adjust.h"
#include "shading/functions/vector_operations.h"

#include <cmath>

namespace eye_render {

namespace {

// Perez, Seals & Michalsky 1993; angles of the direction to the zenith and to the sun.
[[nodiscard]] float perez(const std::array<float, 5>& p, float to_zenith_rad, float to_sun_rad)
{
    const float cosine = std::cos(to_sun_rad);
    return (1.0f + p[0] * std::exp(p[1] / std::cos(to_zenith_rad))) *
           (1.0f + p[2] * std::exp(p[3] * to_sun_rad) + p[4] * cosine * cosine);
}

// Cubic in the sun's zenith angle.
[[nodiscard]] float cubic(float angle, float c3, float c2, float c1, float c0)
{
    return ((c3 * angle + c2) * angle + c1) * angle + c0;
}

[[nodiscard]] float angle_to(const V3f& a, const V3f& b)
{
    return std::acos(clamp_between(a.dot(b), -1.0f, 1.0f));
}

}  // namespace

PreethamSky::PreethamSky(const V3f& sun, float turbidity, WorkingSpace space)
    : space_(space), sun_(safe_normalized(sun))
{
    const float t = turbidity;
    const float angle = angle_to(sun_, V3f(0.0f, 0.0f, 1.0f));
    luminance_.perez = {0.1787f * t - 1.4630f, -0.3554f * t + 0.4275f, -0.0227f * t + 5.3251f,
                        0.1206f * t - 2.5771f, -0.0670f * t + 0.3703f};
    x_.perez = {-0.0193f * t - 0.2592f, -0.0665f * t + 0.0008f, -0.0004f * t + 0.2125f,
                -0.0641f * t - 0.8989f, -0.0033f * t + 0.0452f};
    y_.perez = {-0.0167f * t - 0.2608f, -0.0950f * t + 0.0092f, -0.0079f * t + 0.2102f,
                -0.0441f * t - 1.6537f, -0.0109f * t + 0.0529f};

    constexpr float brightness = 0.06f;  // of a kcd/m^2, in Blender's pictures
    const float chi = (4.0f / 9.0f - t / 120.0f) * static_cast<float>(pi) -
                      2.0f * (4.0f / 9.0f - t / 120.0f) * angle;
    const float zenith = (4.0453f * t - 4.9710f) * std::tan(chi) - 0.2155f * t + 2.4192f;
    const float zenith_x = cubic(angle, 0.00166f, -0.00375f, 0.00209f, 0.0f) * t * t +
                           cubic(angle, -0.02903f, 0.06377f, -0.03202f, 0.00394f) * t +
                           cubic(angle, 0.11693f, -0.21196f, 0.06052f, 0.25886f);
    const float zenith_y = cubic(angle, 0.00275f, -0.00610f, 0.00317f, 0.0f) * t * t +
                           cubic(angle, -0.04214f, 0.08970f, -0.04153f, 0.00516f) * t +
                           cubic(angle, 0.15346f, -0.26756f, 0.06670f, 0.26688f);
    luminance_.scale = zenith * brightness / perez(luminance_.perez, 0.0f, angle);
    x_.scale = zenith_x / perez(x_.perez, 0.0f, angle);
    y_.scale = zenith_y / perez(y_.perez, 0.0f, angle);
}

Color3f PreethamSky::radiance(const V3f& direction) const
{
    // Below the horizon the sky goes on as it is there.
    constexpr float furthest = 0.5f * static_cast<float>(pi) - 0.001f;
    const float to_zenith = std::min(std::acos(clamp_between(direction.z, -1.0f, 1.0f)), furthest);
    const float to_sun = angle_to(direction, sun_);
    const auto value = [&](const Channel& channel) {
        return channel.scale * perez(channel.perez, to_zenith, to_sun);
    };
    const float luminance = value(luminance_);
    const float x = value(x_);
    const float y = value(y_);
    return not_negative(rgb_from_xyz(
        {safe_divide(x, y) * luminance, luminance, safe_divide(1.0f - x - y, y) * luminance},
        space_));
}

}  // namespace eye_render
