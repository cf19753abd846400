#include "render/shutter.h"

#include "base/error.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace eye_render {

namespace {

constexpr double most_open = 1e6;

}  // namespace

Shutter::Shutter(const std::vector<double>& openness) : density_(openness)
{
    if (openness.size() < 2) {
        throw std::invalid_argument("shutter_curve has fewer than two values");
    }
    const double step = 1.0 / static_cast<double>(openness.size() - 1);
    closed_before_.push_back(0.0);
    for (std::size_t i = 0; i < openness.size(); ++i) {
        require_range("shutter_curve", openness[i], 0.0, most_open, "");
        if (i > 0) {
            closed_before_.push_back(closed_before_.back() +
                                     0.5 * step * (openness[i - 1] + openness[i]));
        }
    }
    const double sum = closed_before_.back();
    if (!(sum > 0.0)) {
        throw std::invalid_argument("shutter_curve is zero everywhere; expected a positive value");
    }
    for (std::size_t i = 0; i < openness.size(); ++i) {
        density_[i] /= sum;
        closed_before_[i] /= sum;
    }
}

float Shutter::sample(float u) const
{
    const auto after = std::upper_bound(closed_before_.begin() + 1, closed_before_.end() - 1,
                                        static_cast<double>(u));
    const auto i = static_cast<std::size_t>(after - closed_before_.begin()) - 1;
    const double a = density_[i];
    const double b = density_[i + 1];
    const auto steps = static_cast<double>(density_.size() - 1);
    // The place in the step, from 0 to 1, where a x + (b - a) x^2 / 2 is the rest of u, by the
    // solution that does not cancel.
    const double rest = std::max(0.0, static_cast<double>(u) - closed_before_[i]) * steps;
    const double root = std::sqrt(std::max(0.0, a * a + 2.0 * (b - a) * rest));
    const double place = a + root > 0.0 ? std::min(1.0, 2.0 * rest / (a + root)) : 0.0;
    return static_cast<float>((static_cast<double>(i) + place) / steps);
}

double Shutter::pdf(double time) const
{
    const auto steps = static_cast<double>(density_.size() - 1);
    const double at = std::clamp(time, 0.0, 1.0) * steps;
    const auto i = std::min(static_cast<std::size_t>(at), density_.size() - 2);
    return std::lerp(density_[i], density_[i + 1], at - static_cast<double>(i));
}

}  // namespace eye_render
