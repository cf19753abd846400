// A curve or a ramp as samples at equal distances over 0 to 1, as the host sampled it.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace eye_render {

// What a function does between its samples, and beyond its ends.
enum class Between { Constant, Linear };
enum class Beyond { Constant, Linear };

// One channel.
class SampledFunction {
public:
    // Throws std::invalid_argument for less than two samples.
    SampledFunction(std::vector<float> samples, Between between, Beyond beyond)
        : samples_(std::move(samples)), between_(between), beyond_(beyond)
    {
        if (samples_.size() < 2) {
            throw std::invalid_argument("a sampled curve has " + std::to_string(samples_.size()) +
                                        " samples; expected 2 or more");
        }
    }

    // What is not a number counts as 0.
    [[nodiscard]] float operator()(float x) const
    {
        const std::size_t last = samples_.size() - 1;
        const auto intervals = static_cast<float>(last);
        if (beyond_ == Beyond::Linear && x < 0.0f) {
            return samples_[0] + (samples_[0] - samples_[1]) * -x * intervals;
        }
        if (beyond_ == Beyond::Linear && x > 1.0f) {
            return samples_[last] + (samples_[last] - samples_[last - 1]) * (x - 1.0f) * intervals;
        }
        const float place = (x > 0.0f ? std::min(x, 1.0f) : 0.0f) * intervals;
        const auto before = static_cast<std::size_t>(place);
        const float rest = place - static_cast<float>(before);
        if (between_ == Between::Constant || rest == 0.0f) {
            return samples_[before];
        }
        return (1.0f - rest) * samples_[before] + rest * samples_[before + 1];
    }

private:
    std::vector<float> samples_;
    Between between_;
    Beyond beyond_;
};

}  // namespace eye_render
