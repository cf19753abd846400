// From Blender's numbers to radiance. Measured with Blender's Cycles on a white plane to 0.1 %
// (tests/scene/lamp_figures.h); P is colour times energy.
//
// Point and spot, P in watts: a sphere of radius r that radiates L everywhere emits
// P = pi L 4 pi r^2, hence L = P / (4 pi^2 r^2), and its intensity is pi r^2 L = P / (4 pi)
// whatever the radius. The facing disk of the same radius has the same L. A spot is the same lamp
// behind a cone, so narrowing the cone does not brighten it.
//
// Sun, P in W/m^2: the irradiance of a plane square to it. A disk of half angle h with constant
// radiance gives L pi sin^2 h, hence L = P / (pi sin^2 h). (Blender 3.4's sun samples the tangent
// plane instead and gives P times 1 - tan^2(h) / 4: 5e-6 less for the real sun.)
//
// Area, P in watts: a Lambertian emitter, L = P / (pi A). With a grid of half spread h it is
// L (1 - tan a / tan h) tan h / (tan h - h) at the angle a, which leaves the flux unchanged:
// the integral of 2 cos a sin a (1 - tan a / tan h) from 0 to h is 1 - h / tan h.

#include "scene/lamp.h"

#include "base/error.h"
#include "base/magnitude.h"
#include "shading/frame.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace eye_render {

namespace {

constexpr double pi_d = std::numbers::pi;
constexpr double largest = std::numeric_limits<float>::max();

// A float holding pi is a little more than pi.
constexpr double straight_angle_rad = pi_d * (1.0 + 1e-7);
// Smaller lamps are points: their radiance would leave the range of a float.
constexpr float smallest_radius = 1e-8f;
constexpr float smallest_sun = 1e-12f;  // 1 - cos, a disk of 0.6 arcsec

// Blender's narrowest grid; below it the lamp would turn into a delta beam.
constexpr double minimum_spread_rad = pi_d / 180.0;
// At this spread the grid hides less than 1e-4 of anything that is not seen edge-on.
constexpr double open_spread_rad = pi_d - 1e-4;

struct AxisLength {
    V3f axis;
    float length = 0.0f;
};

AxisLength split(const V3f& v, const V3f& fallback)
{
    const float length = v.length();
    return length > 0.0f ? AxisLength{v / length, length} : AxisLength{fallback, 0.0f};
}

V3f row(const M44f& m, int i) { return {m[i][0], m[i][1], m[i][2]}; }

void check(const LampSettings& settings)
{
    for (int i = 0; i < 4; ++i) {
        for (int j = 0; j < 3; ++j) {
            require_range("world_from_light", settings.world_from_light[i][j], -largest, largest,
                          i == 3 ? "units" : "");
        }
    }
    for (int i = 0; i < 3; ++i) {
        require_range("color", settings.color[i], -largest, largest, "W");
    }
    require_range("radius", settings.radius, 0.0, largest, "units");
    require_range("angle_rad", settings.angle_rad, 0.0, straight_angle_rad, "rad");
    require_range("spot_angle_rad", settings.spot_angle_rad, 0.0, straight_angle_rad, "rad");
    require_range("spot_blend", settings.spot_blend, 0.0, 1.0, "");
    require_range("size_x", settings.size_x, 0.0, largest, "units");
    require_range("size_y", settings.size_y, 0.0, largest, "units");
    require_range("spread_rad", settings.spread_rad, 0.0, straight_angle_rad, "rad");
}

// 1 - cos(angle), without the cancellation at the angle of the sun.
double one_minus_cos(double angle_rad)
{
    const double s = std::sin(0.5 * angle_rad);
    return 2.0 * s * s;
}

void make_spot(Lamp& lamp, const LampSettings& settings, const V3f& scale)
{
    const double edge = one_minus_cos(0.5 * settings.spot_angle_rad);
    lamp.one_minus_cos_half_angle = static_cast<float>(edge);
    lamp.spot_smooth = static_cast<float>(edge * settings.spot_blend);
    lamp.spot_cosine_falloff = settings.spot_cosine_falloff;
    if (!settings.spot_cosine_falloff && scale.x > 0.0f && scale.y > 0.0f) {
        lamp.spot_scale_x = scale.z / scale.x;
        lamp.spot_scale_y = scale.z / scale.y;
    }
}

void make_area(Lamp& lamp, const LampSettings& settings, const V3f& scale)
{
    lamp.is_delta = false;
    lamp.shape = settings.shape;
    lamp.half_x = 0.5f * std::max(minimum_area_size, settings.size_x * scale.x);
    lamp.half_y = 0.5f * std::max(minimum_area_size, settings.size_y * scale.y);
    double gain = 1.0 / (pi_d * area_lamp_area(lamp));
    if (settings.spread_rad < open_spread_rad) {
        const double half = 0.5 * std::max<double>(settings.spread_rad, minimum_spread_rad);
        const double cotangent = 1.0 / std::tan(half);
        lamp.cot_half_spread = static_cast<float>(cotangent);
        gain /= 1.0 - half * cotangent;
    }
    lamp.emission = settings.color * static_cast<float>(gain);
}

}  // namespace

Lamp make_lamp(const LampSettings& settings)
{
    check(settings);
    Lamp lamp;
    lamp.kind = settings.kind;
    lamp.casts_shadow = settings.casts_shadow;
    lamp.visibility = settings.visibility;
    lamp.position = row(settings.world_from_light, 3);

    // Orthogonal axes even from a sheared matrix, which no lamp can follow.
    const AxisLength x = split(row(settings.world_from_light, 0), V3f(1.0f, 0.0f, 0.0f));
    const AxisLength z = split(row(settings.world_from_light, 2), V3f(0.0f, 0.0f, 1.0f));
    const V3f y_raw = row(settings.world_from_light, 1);
    lamp.axis_z = z.axis;
    lamp.axis_x = split(x.axis - z.axis * x.axis.dot(z.axis), Frame(z.axis).s).axis;
    lamp.axis_y = z.axis.cross(lamp.axis_x);
    const V3f scale(x.length, y_raw.length(), z.length);

    switch (settings.kind) {
    case LampKind::Sun: {
        const double half = 0.5 * settings.angle_rad;
        const double sine = std::sin(half);
        lamp.one_minus_cos_half_angle = static_cast<float>(one_minus_cos(half));
        lamp.is_delta = !(lamp.one_minus_cos_half_angle > smallest_sun);
        lamp.emission = lamp.is_delta
                            ? settings.color
                            : settings.color * static_cast<float>(1.0 / (pi_d * sine * sine));
        break;
    }
    case LampKind::Area: make_area(lamp, settings, scale); break;
    case LampKind::Spot: make_spot(lamp, settings, scale); [[fallthrough]];
    case LampKind::Point: {
        const double r = settings.radius;
        lamp.radius = settings.radius;
        lamp.is_delta = !(settings.radius > smallest_radius);
        lamp.is_sphere = !settings.soft_falloff;
        const double per_watt = lamp.is_delta ? 0.25 / pi_d : 0.25 / (pi_d * pi_d * r * r);
        lamp.emission = settings.color * static_cast<float>(per_watt);
        break;
    }
    }
    return lamp;
}

float lamp_peak_intensity(const Lamp& lamp)
{
    const float emission = luminance(magnitude(lamp.emission)) * lamp.brightness;
    if (lamp.is_delta) {
        return emission;
    }
    if (lamp.kind == LampKind::Sun) {
        const float m = lamp.one_minus_cos_half_angle;
        return emission * std::numbers::pi_v<float> * m * (2.0f - m);  // L pi sin^2
    }
    return emission * (lamp.kind == LampKind::Area
                           ? area_lamp_area(lamp)
                           : std::numbers::pi_v<float> * lamp.radius * lamp.radius);
}

}  // namespace eye_render
