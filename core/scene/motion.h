// What changes while the shutter is open, as values at equally spaced times: the first at time 0,
// when it opens, the last at time 1, when it closes. A single value keeps still.

#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace eye_render {

// When the shutter is half way: the time of all that keeps still.
inline constexpr float shutter_middle = 0.5f;

// Between which steps a time lies.
struct MotionPlace {
    std::size_t step = 0;
    float weight = 0.0f;  // of the step after it
};

// Of at least two steps.
[[nodiscard]] inline MotionPlace motion_place(std::size_t steps, float time)
{
    const float at = std::clamp(time, 0.0f, 1.0f) * static_cast<float>(steps - 1);
    const std::size_t step = std::min(static_cast<std::size_t>(at), steps - 2);
    return {step, at - static_cast<float>(step)};
}

// Values that many things have, at one step or several.
template <typename T>
struct MotionSteps {
    std::vector<std::span<const T>> steps;

    [[nodiscard]] T at(std::size_t index, float time) const
    {
        if (steps.size() == 1) {
            return steps.front()[index];
        }
        const MotionPlace place = motion_place(steps.size(), time);
        return steps[place.step][index] * (1.0f - place.weight) +
               steps[place.step + 1][index] * place.weight;
    }
};

// The one of `values` at the shutter's middle, or that of `moving` at the time, if there are any.
template <typename T>
[[nodiscard]] T at_time(const std::vector<T>& values,
                        const std::vector<std::vector<T>>& moving,
                        std::size_t index,
                        float time)
{
    if (moving.empty()) {
        return values[index];
    }
    const MotionPlace place = motion_place(moving.size(), time);
    return moving[place.step][index] * (1.0f - place.weight) +
           moving[place.step + 1][index] * place.weight;
}

}  // namespace eye_render
