// Arithmetic as Blender's nodes do it: 0 where mathematics has no answer, so that one bad texel
// does not spread. Infinities and what is not a number pass through where IEEE 754 lets them.

#pragma once

#include <algorithm>
#include <cmath>

namespace eye_render {

[[nodiscard]] inline float safe_divide(float a, float b) { return b != 0.0f ? a / b : 0.0f; }

// NaN becomes `low`; `high` wins where the limits are the wrong way round.
[[nodiscard]] inline float clamp_between(float x, float low, float high)
{
    const float raised = x > low ? x : low;
    return raised < high ? raised : high;
}

[[nodiscard]] inline float clamp_to_unit(float x) { return clamp_between(x, 0.0f, 1.0f); }

// 0 for a negative base, unless the exponent is a whole number that an int holds.
[[nodiscard]] inline float safe_power(float base, float exponent)
{
    constexpr float int_limit = 2147483648.0f;
    const bool is_whole = std::abs(exponent) < int_limit && exponent == std::trunc(exponent);
    return base < 0.0f && !is_whole ? 0.0f : std::pow(base, exponent);
}

// Logarithm of `x` to any positive base.
[[nodiscard]] inline float safe_logarithm(float x, float base)
{
    return x <= 0.0f || base <= 0.0f ? 0.0f : safe_divide(std::log(x), std::log(base));
}

[[nodiscard]] inline float safe_sqrt(float x) { return std::sqrt(x > 0.0f ? x : 0.0f); }

[[nodiscard]] inline float safe_inverse_sqrt(float x)
{
    return x > 0.0f ? 1.0f / std::sqrt(x) : 0.0f;
}

// The remainder has the sign of `a`.
[[nodiscard]] inline float safe_modulo(float a, float b)
{
    return b != 0.0f ? std::fmod(a, b) : 0.0f;
}

// The remainder has the sign of `b`.
[[nodiscard]] inline float safe_floored_modulo(float a, float b)
{
    return b != 0.0f ? a - std::floor(a / b) * b : 0.0f;
}

[[nodiscard]] inline float fraction(float x) { return x - std::floor(x); }

// Down to a multiple of `step`.
[[nodiscard]] inline float snap(float x, float step)
{
    return std::floor(safe_divide(x, step)) * step;
}

// Repeats the interval from `low` to `high`.
[[nodiscard]] inline float wrap(float x, float high, float low)
{
    const float range = high - low;
    return range != 0.0f ? x - range * std::floor((x - low) / range) : low;
}

// Goes to `scale` and back to 0.
[[nodiscard]] inline float ping_pong(float x, float scale)
{
    const float turn = fraction(safe_divide((x - scale) * 0.5f, scale));
    return std::abs(scale * (2.0f * turn - 1.0f));
}

// The lesser, with the corner rounded where they differ by less than `distance`: cubic (Quilez
// 2013, "Smooth minimum").
[[nodiscard]] inline float smooth_minimum(float a, float b, float distance)
{
    if (distance == 0.0f) {
        return std::fmin(a, b);
    }
    const float h = std::fmax(distance - std::abs(a - b), 0.0f) / distance;
    return std::fmin(a, b) - h * h * h * distance * (1.0f / 6.0f);
}

[[nodiscard]] inline float smooth_maximum(float a, float b, float distance)
{
    return -smooth_minimum(-a, -b, distance);
}

// 0 of 0; what is not a number counts as positive.
[[nodiscard]] inline float sign(float x) { return x == 0.0f ? 0.0f : (x < 0.0f ? -1.0f : 1.0f); }

}  // namespace eye_render
