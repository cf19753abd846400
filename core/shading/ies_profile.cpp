#include "shading/ies_profile.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace eye_render {

namespace {

// Files say angles to a tenth of a degree at best; 360 degrees in float is off by less.
constexpr float same_angle_rad = 1e-5f;

[[nodiscard]] float catmull_rom(float before, float first, float second, float after, float t)
{
    const float slope_first = 0.5f * (second - before);
    const float slope_second = 0.5f * (after - first);
    const float rise = second - first;
    const float square = 3.0f * rise - 2.0f * slope_first - slope_second;
    const float cube = slope_first + slope_second - 2.0f * rise;
    return first + t * (slope_first + t * (square + t * cube));
}

struct Interval {
    std::size_t first;
    float share;  // of the way to the next one
};

// The angles that `angle` lies between, which is not before the first nor after the last.
[[nodiscard]] Interval interval_of(const std::vector<float>& angles, float angle)
{
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    const auto last = static_cast<std::size_t>(angles.size() - 2);
    const auto first = std::min(static_cast<std::size_t>(above - angles.begin()) - 1, last);
    const float width = angles[first + 1] - angles[first];
    return {first, width > 0.0f ? (angle - angles[first]) / width : 0.0f};
}

void require_ascending(const char* what, const std::vector<float>& angles)
{
    if (angles.empty() || !std::ranges::is_sorted(angles)) {
        throw std::invalid_argument(std::string("IES profile: the ") + what +
                                    " angles do not ascend");
    }
}

}  // namespace

IesProfile::IesProfile(std::vector<float> horizontal_rad,
                       std::vector<float> vertical_rad,
                       std::vector<float> watts)
    : horizontal_rad_(std::move(horizontal_rad)), vertical_rad_(std::move(vertical_rad)),
      watts_(std::move(watts))
{
    require_ascending("horizontal", horizontal_rad_);
    require_ascending("vertical", vertical_rad_);
    has_nadir_ = std::abs(vertical_rad_.front()) < same_angle_rad;
}

float IesProfile::along_vertical(std::size_t row, std::size_t first, float share) const
{
    const std::size_t count = vertical_rad_.size();
    const float* values = &watts_[row * count];
    const float before = first > 0 ? values[first - 1] : has_nadir_ ? values[1] : 0.0f;
    const float after = first + 2 < count ? values[first + 2] : 0.0f;
    return catmull_rom(before, values[first], values[first + 1], after, share);
}

float IesProfile::at(float horizontal_rad, float vertical_rad) const
{
    const std::size_t rows = horizontal_rad_.size();
    if (rows < 2 || vertical_rad_.size() < 2) {
        return 0.0f;
    }
    // False for NaN, too.
    const bool is_measured = vertical_rad >= vertical_rad_.front() &&
                             vertical_rad < vertical_rad_.back() &&
                             horizontal_rad >= horizontal_rad_.front() - same_angle_rad &&
                             horizontal_rad <= horizontal_rad_.back() + same_angle_rad;
    if (!is_measured) {
        return 0.0f;
    }
    const Interval h =
        interval_of(horizontal_rad_,
                    std::clamp(horizontal_rad, horizontal_rad_.front(), horizontal_rad_.back()));
    const Interval v = interval_of(vertical_rad_, vertical_rad);
    const auto row = [&](std::size_t number) { return along_vertical(number, v.first, v.share); };
    const float before = h.first > 0 ? row(h.first - 1) : 0.0f;
    const float after = h.first + 2 < rows ? row(h.first + 2) : 0.0f;
    return std::max(0.0f, catmull_rom(before, row(h.first), row(h.first + 1), after, h.share));
}

}  // namespace eye_render
