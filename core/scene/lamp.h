// Lamps: Blender's point, sun, spot and area lights, with the radiance that Cycles gives them.
//
// Space: world, float, relative to the eye. A direction `wi` is unit and points from the lit
// point to the lamp. Probabilities are per unit solid angle at the lit point. A point or spot
// lamp with a radius is a disk turned to the lit point (Blender's "soft falloff", its default) or
// a sphere that shines outwards. An area lamp shines to its local -Z only, a spot along its local
// -Z, and the sun's light travels along its local -Z.

#pragma once

#include "base/vector.h"
#include "scene/visibility.h"

#include <numbers>
#include <optional>

namespace eye_render {

enum class LampKind { Point, Sun, Spot, Area };
enum class LampShape { Rectangle, Disk };

// A lamp as Blender describes it.
struct LampSettings {
    LampKind kind = LampKind::Point;
    M44f world_from_light{};   // row-vector convention; its scale stretches area lamps and spot
                               // cones
    Color3f color{0.0f};       // colour times energy: W, for the sun W/m^2; negative takes light
                               // away
    float radius = 0.0f;       // point and spot, scene units; 0 is a delta lamp
    bool soft_falloff = true;  // point and spot: a disk turned to the lit point, or a sphere
    float angle_rad = 0.0f;    // sun: full angle that its disk subtends; 0 is a delta lamp
    float spot_angle_rad = 0.785398f;  // full opening angle of the cone
    float spot_blend = 0.15f;          // 0 (hard edge) to 1
    // Blender 3.4 also dims a spot by the cosine of the angle from its axis, and leaves its cone
    // unscaled; later versions do not dim, and scale it.
    bool spot_cosine_falloff = false;
    LampShape shape = LampShape::Rectangle;
    float size_x = 1.0f;  // area: full width (of the disk: diameter), before scaling
    float size_y = 1.0f;
    float spread_rad = 3.1415927f;  // area: full angle that its honeycomb grid lets through
    bool casts_shadow = true;
    Visibility visibility{.to_camera = false};  // to what scatters its light
    // Its nodes find the lamp's own space where they ask for an object's; else the world, as
    // before Blender 4.4.
    bool has_own_space = true;
};

// A lamp as the queries below want it. Plain data; `make_lamp` derives it.
struct Lamp {
    LampKind kind = LampKind::Point;
    LampShape shape = LampShape::Rectangle;
    bool is_delta = true;
    bool is_sphere = false;  // point and spot with a radius; else the disk turned to the point
    bool casts_shadow = true;
    bool spot_cosine_falloff = false;
    V3f position{0.0f};            // not for the sun
    V3f axis_x{1.0f, 0.0f, 0.0f};  // unit, orthogonal
    V3f axis_y{0.0f, 1.0f, 0.0f};
    V3f axis_z{0.0f, 0.0f, 1.0f};  // the light leaves along -axis_z
    Visibility visibility{.to_camera = false};
    // Luminance of what its nodes multiply the emission by, at the most and whatever its sign.
    float brightness = 1.0f;
    // Peak radiance, or trough; for delta lamps radiant intensity (point, spot) or irradiance
    // (sun).
    Color3f emission{0.0f};
    float radius = 0.0f;  // point and spot
    float half_x = 0.0f;  // area: half extents, scaled
    float half_y = 0.0f;
    float one_minus_cos_half_angle = 0.0f;  // of the sun's disk, or of the spot's cone
    float spot_smooth = 0.0f;               // spot: width of the soft edge, in cosine
    float spot_scale_x = 1.0f;              // spot: stretch of the cone against its length
    float spot_scale_y = 1.0f;
    float cot_half_spread = 0.0f;  // area: 0 without a grid
    // Of one that moves while the shutter is open: this is half way, and a ball around `position`
    // holds all of its places.
    bool moves = false;
    float reach = 0.0f;
};

// Area lamps are made at least this wide, so that one squashed flat keeps its power.
inline constexpr float minimum_area_size = 1e-4f;

// Throws std::invalid_argument for a negative or non-finite size, or an angle outside its range.
[[nodiscard]] Lamp make_lamp(const LampSettings& settings);

struct LampSample {
    V3f wi;
    float distance = 0.0f;  // to the point on the lamp; infinity for the sun
    // For a delta lamp this is what arrives, so that f |cos| radiance / pdf holds with pdf = 1.
    Color3f radiance;
    float pdf = 0.0f;
    bool is_delta = false;
};

// A direction from `p_world` to the lamp, u in [0,1)^2. Nothing if the lamp cannot light the
// point.
[[nodiscard]] std::optional<LampSample> sample_lamp(const Lamp& lamp,
                                                    const V3f& p_world,
                                                    const V2f& u);

struct LampHit {
    float t = 0.0f;  // infinity for the sun
    Color3f radiance;
    float pdf = 0.0f;  // of sample_lamp choosing this direction from the ray's origin
};

// The lamp met by a ray, for rays that a BSDF chose. `direction` is unit. Never a delta lamp.
[[nodiscard]] std::optional<LampHit> lamp_hit(const Lamp& lamp,
                                              const V3f& origin_world,
                                              const V3f& direction,
                                              float t_max);

[[nodiscard]] inline float area_lamp_area(const Lamp& lamp)
{
    const float shape_factor = lamp.shape == LampShape::Disk ? std::numbers::pi_v<float> : 4.0f;
    return shape_factor * lamp.half_x * lamp.half_y;
}

// Luminance of the radiant intensity along the brightest direction, whatever its sign; for the
// sun, of the irradiance. Divided by the squared distance it is the most that a far point can get.
[[nodiscard]] float lamp_peak_intensity(const Lamp& lamp);

}  // namespace eye_render
