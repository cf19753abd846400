// The Map Range node: a number carried from one interval to another, straight, in steps or along
// an S. As in Cycles, numbers and vectors differ where the first interval is empty or reversed.

#pragma once

#include "shading/functions/safe_math.h"

namespace eye_render {

enum class RangeInterpolation { Linear, Stepped, Smoothstep, Smootherstep };

struct RangeMap {
    float from_min = 0.0f;
    float from_max = 1.0f;
    float to_min = 0.0f;
    float to_max = 1.0f;
    float steps = 4.0f;  // read by Stepped alone
};

[[nodiscard]] inline float smoothstep(float t) { return (3.0f - 2.0f * t) * (t * t); }

[[nodiscard]] inline float smootherstep(float t)
{
    return t * t * t * (t * (t * 6.0f - 15.0f) + 10.0f);
}

// `place` is 0 at the first interval's start and 1 at its end; so is what comes out.
[[nodiscard]] inline float eased(RangeInterpolation interpolation, float place, float steps)
{
    switch (interpolation) {
    case RangeInterpolation::Stepped:
        return steps > 0.0f ? std::floor(place * (steps + 1.0f)) / steps : 0.0f;
    case RangeInterpolation::Smoothstep: return smoothstep(clamp_to_unit(place));
    case RangeInterpolation::Smootherstep: return smootherstep(clamp_to_unit(place));
    default: return place;
    }
}

// An empty first interval puts everything at the second's start.
[[nodiscard]] inline float map_range_component(RangeInterpolation interpolation,
                                               float x,
                                               const RangeMap& map)
{
    const float place = safe_divide(x - map.from_min, map.from_max - map.from_min);
    return map.to_min + eased(interpolation, place, map.steps) * (map.to_max - map.to_min);
}

// An empty first interval gives 0.
[[nodiscard]] inline float map_range(RangeInterpolation interpolation,
                                     float x,
                                     const RangeMap& map)
{
    return map.from_max != map.from_min ? map_range_component(interpolation, x, map) : 0.0f;
}

// Between the ends of the second interval, whichever is the greater.
[[nodiscard]] inline float clamp_to_range(float y, const RangeMap& map)
{
    return map.to_min > map.to_max ? clamp_between(y, map.to_max, map.to_min)
                                   : clamp_between(y, map.to_min, map.to_max);
}

}  // namespace eye_render
