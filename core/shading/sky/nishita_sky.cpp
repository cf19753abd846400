#include "shading/sky/nishita_sky.h"

#include "base/units.h"
#include "shading/functions/color_adjust.h"
#include "shading/sky/sun_position.h"

#include <cmath>

namespace eye_render {

namespace {

constexpr float half_turn = static_cast<float>(pi);

// As large as Blender's, so that what its interpolation blurs is blurred alike.
constexpr int table_width = 512;
constexpr int table_height = 128;
constexpr int half_width = table_width / 2;

[[nodiscard]] std::size_t place_in_table(int column, int row)
{
    return std::size_t{half_width} * static_cast<std::size_t>(row) +
           static_cast<std::size_t>(column);
}

[[nodiscard]] Air air_of(const NishitaSettings& settings)
{
    // Not on the ground itself and not in space, where the way through the air has no length.
    constexpr double lowest_m = 1.0;
    constexpr double highest_m = 59999.0;
    return {settings.atmosphere, std::clamp(settings.altitude_m, lowest_m, highest_m)};
}

// Exact for small angles, too.
[[nodiscard]] float angle_between(const V3f& a, const V3f& b)
{
    return 2.0f * std::atan2((a - b).length(), (a + b).length());
}

[[nodiscard]] float elevation_of(const V3f& direction)
{
    return 0.5f * half_turn - std::acos(clamp_between(direction.z, -1.0f, 1.0f));
}

}  // namespace

NishitaSun::NishitaSun(const NishitaSettings& settings, WorkingSpace space)
    : has_disc_(settings.has_disc)
{
    // A smaller disc would be lost in rounding.
    constexpr double smallest_rad = 0.0005;
    const SunPosition position =
        sun_position(settings.sun_elevation_rad, settings.sun_rotation_rad);
    const double radius_rad = 0.5 * std::max(settings.sun_size_rad, smallest_rad);
    direction_ = V3f(direction_at(position.elevation_rad, 0.5 * pi - position.rotation_rad));
    elevation_rad_ = static_cast<float>(position.elevation_rad);
    radius_rad_ = static_cast<float>(radius_rad);
    if (!has_disc_) {
        return;
    }
    const Air air = air_of(settings);
    // In single precision as Blender's: how it rounds is seen in small suns.
    const float solid_angle_sr = 2.0f * half_turn * (1.0f - std::cos(radius_rad_));
    const auto seen_at = [&](double elevation_rad) {
        const V3d xyz = air.sunlight_xyz(direction_at(std::max(elevation_rad, 0.0), 0.0));
        return rgb_from_xyz(
            V3f(xyz * (settings.sun_intensity / static_cast<double>(solid_angle_sr))), space);
    };
    lower_ = seen_at(position.elevation_rad - radius_rad);
    upper_ = seen_at(position.elevation_rad + radius_rad);
}

std::optional<Color3f> NishitaSun::radiance(const V3f& direction) const
{
    const float angle = angle_between(direction, direction_);
    if (!has_disc_ || !(angle < radius_rad_) || direction.z < 0.0f) {
        return std::nullopt;
    }
    // From the lower end of what is above the horizon to the upper.
    const float lowest = std::max(elevation_rad_ - radius_rad_, 0.0f);
    const float height =
        (elevation_of(direction) - lowest) / (elevation_rad_ + radius_rad_ - lowest);
    const float from_middle = angle / radius_rad_;
    constexpr float limb_darkening = 0.6f;
    const float limb =
        1.0f - limb_darkening * (1.0f - safe_sqrt(1.0f - from_middle * from_middle));
    return not_negative((lower_ + (upper_ - lower_) * height) * limb);
}

std::optional<SunDisc> NishitaSun::disc() const
{
    if (!has_disc_ || !(elevation_rad_ + radius_rad_ > 0.0f)) {
        return std::nullopt;
    }
    return SunDisc{.direction = direction_,
                   .radius_rad = radius_rad_,
                   .radiance = not_negative((lower_ + upper_) * 0.5f)};
}

NishitaSky::NishitaSky(const NishitaSettings& settings, WorkingSpace space)
    : sun_(settings, space), sun_hides_sky_(settings.sun_hides_sky),
      table_(std::size_t{half_width} * table_height)
{
    const SunPosition position =
        sun_position(settings.sun_elevation_rad, settings.sun_rotation_rad);
    rotation_rad_ = static_cast<float>(position.rotation_rad);
    const Air air = air_of(settings);
    const V3d sun = direction_at(position.elevation_rad, 0.0);
    constexpr double highest_rad = 0.5 * pi * (1.0 + 0.5 / table_height);
    for (int y = 0; y < table_height; ++y) {
        const double row = static_cast<double>(y) / table_height;
        for (int x = 0; x < half_width; ++x) {
            const V3d direction =
                direction_at(highest_rad * row * row, 2.0 * pi * x / table_width - pi);
            table_[place_in_table(x, y)] =
                rgb_from_xyz(V3f(air.scattered_xyz(direction, sun)), space);
        }
    }
}

// `x` in turns with the sun at a half, `y` in rows; the ends continue as they are.
Color3f NishitaSky::interpolated(float x, float y) const
{
    const auto texel = [&](int column, int row) {
        const int mirrored = column < half_width ? column : table_width - 1 - column;
        return table_[place_in_table(mirrored, row)];
    };
    constexpr auto last_column = static_cast<float>(table_width - 1);
    constexpr auto last_row = static_cast<float>(table_height - 1);
    const float column = clamp_between(x * table_width - 0.5f, 0.0f, last_column);
    const float row = clamp_between(y * table_height - 0.5f, 0.0f, last_row);
    const int left = static_cast<int>(column);
    const int below = static_cast<int>(row);
    const int right = std::min(left + 1, table_width - 1);
    const int above = std::min(below + 1, table_height - 1);
    const float s = column - static_cast<float>(left);
    const float t = row - static_cast<float>(below);
    return (texel(left, below) * (1.0f - s) + texel(right, below) * s) * (1.0f - t) +
           (texel(left, above) * (1.0f - s) + texel(right, above) * s) * t;
}

Color3f NishitaSky::radiance(const V3f& direction) const
{
    const std::optional<Color3f> sun = sun_.radiance(direction);
    if (!sun) {
        return without_sun(direction);
    }
    return sun_hides_sky_ ? *sun : *sun + without_sun(direction);
}

Color3f NishitaSky::without_sun(const V3f& direction) const
{
    const float azimuth = std::atan2(direction.x, direction.y);  // clockwise from +Y
    const float turns = (azimuth - rotation_rad_) / (2.0f * half_turn) + 0.5f;
    const float x = fraction(turns);
    if (direction.z >= 0.0f) {
        const float y = safe_sqrt(elevation_of(direction) / (0.5f * half_turn));
        return not_negative(interpolated(x, y));
    }
    // The ground is black, and the horizon's light fades into it.
    constexpr float fades_below = 2.5f;
    const float fade = std::max(1.0f + direction.z * fades_below, 0.0f);
    return not_negative(interpolated(x, 0.0f) * (fade * fade * fade));
}

}  // namespace eye_render
