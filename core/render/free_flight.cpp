#include "render/free_flight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace eye_render {

namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// Against the distances around it: a pivot on the ray itself would be all that is ever drawn.
constexpr float least_height = 1e-4f;

}  // namespace

FreeFlight::FreeFlight(const Color3f& extinction, const Color3f& importance, float length)
    : extinction_(extinction), share_(importance / (importance.x + importance.y + importance.z)),
      length_(length)
{
}

int FreeFlight::choose_channel(float u) const
{
    int channel = 0;
    while (channel < 2 && u >= share_[channel]) {
        u -= share_[channel++];
    }
    // Rounding may leave the last channel a little that is not its own.
    while (channel > 0 && share_[channel] <= 0.0f) {
        --channel;
    }
    return channel;
}

float FreeFlight::sample(float u_channel, float u) const
{
    const float extinction = extinction_[choose_channel(u_channel)];
    return extinction > 0.0f ? -std::log1p(-u) / extinction : infinity;
}

float FreeFlight::pdf(float distance) const
{
    float sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        sum += share_[c] * extinction_[c] * std::exp(-extinction_[c] * distance);
    }
    return sum;
}

float FreeFlight::survival(float distance) const
{
    float sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        sum += share_[c] * (extinction_[c] > 0.0f ? std::exp(-extinction_[c] * distance) : 1.0f);
    }
    return sum;
}

float FreeFlight::sample_within(float u_channel, float u) const
{
    const float extinction = extinction_[choose_channel(u_channel)];
    const float distance = -std::log1p(u * std::expm1(-extinction * length_)) / extinction;
    return std::min(distance, length_);
}

float FreeFlight::pdf_within(float distance) const
{
    float sum = 0.0f;
    for (int c = 0; c < 3; ++c) {
        if (share_[c] > 0.0f) {
            sum += share_[c] * extinction_[c] * std::exp(-extinction_[c] * distance) /
                   -std::expm1(-extinction_[c] * length_);
        }
    }
    return sum;
}

EquiangularDistance::EquiangularDistance(const V3f& origin,
                                         const V3f& direction,
                                         float length,
                                         const V3f& pivot)
    : nearest_((pivot - origin).dot(direction)), length_(length)
{
    const float height = (origin + direction * nearest_ - pivot).length();
    const float scale = std::max(std::abs(nearest_), std::min(length, (pivot - origin).length()));
    height_ = std::max({height, least_height * scale, std::numeric_limits<float>::min()});
    first_rad_ = std::atan2(-nearest_, height_);
    last_rad_ = std::atan2(length - nearest_, height_);
}

float EquiangularDistance::sample(float u) const
{
    const float angle_rad = first_rad_ + u * (last_rad_ - first_rad_);
    return std::clamp(nearest_ + height_ * std::tan(angle_rad), 0.0f, length_);
}

float EquiangularDistance::pdf(float distance) const
{
    const float along = distance - nearest_;
    return height_ / ((last_rad_ - first_rad_) * (height_ * height_ + along * along));
}

}  // namespace eye_render
