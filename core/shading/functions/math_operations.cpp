#include "shading/functions/math_operations.h"

#include "shading/functions/named_rows.h"
#include "shading/functions/safe_math.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace eye_render {

namespace {

constexpr float degrees_per_radian = 180.0f / std::numbers::pi_v<float>;

float add(float a, float b, float /*c*/) { return a + b; }
float subtract(float a, float b, float /*c*/) { return a - b; }
float multiply(float a, float b, float /*c*/) { return a * b; }
float divide(float a, float b, float /*c*/) { return safe_divide(a, b); }
float multiply_add(float a, float b, float c) { return a * b + c; }

float power(float a, float b, float /*c*/) { return safe_power(a, b); }
float logarithm(float a, float b, float /*c*/) { return safe_logarithm(a, b); }
float square_root(float a, float /*b*/, float /*c*/) { return safe_sqrt(a); }
float inverse_square_root(float a, float /*b*/, float /*c*/) { return safe_inverse_sqrt(a); }
float absolute(float a, float /*b*/, float /*c*/) { return std::abs(a); }
float exponent(float a, float /*b*/, float /*c*/) { return std::exp(a); }

float minimum(float a, float b, float /*c*/) { return std::fmin(a, b); }
float maximum(float a, float b, float /*c*/) { return std::fmax(a, b); }
float less_than(float a, float b, float /*c*/) { return a < b ? 1.0f : 0.0f; }
float greater_than(float a, float b, float /*c*/) { return a > b ? 1.0f : 0.0f; }
float sign_of(float a, float /*b*/, float /*c*/) { return sign(a); }
// Equal infinities differ by what is not a number.
float compare(float a, float b, float c)
{
    const float distance = std::fmax(c, std::numeric_limits<float>::epsilon());
    return a == b || std::abs(a - b) <= distance ? 1.0f : 0.0f;
}

float round_half_up(float a, float /*b*/, float /*c*/) { return std::floor(a + 0.5f); }
float floor_of(float a, float /*b*/, float /*c*/) { return std::floor(a); }
float ceiling(float a, float /*b*/, float /*c*/) { return std::ceil(a); }
float truncate(float a, float /*b*/, float /*c*/) { return std::trunc(a); }
float fraction_of(float a, float /*b*/, float /*c*/) { return fraction(a); }
float modulo(float a, float b, float /*c*/) { return safe_modulo(a, b); }
float floored_modulo(float a, float b, float /*c*/) { return safe_floored_modulo(a, b); }
float snap_to(float a, float b, float /*c*/) { return snap(a, b); }
float ping_pong_of(float a, float b, float /*c*/) { return ping_pong(a, b); }

float sine(float a, float /*b*/, float /*c*/) { return std::sin(a); }
float cosine(float a, float /*b*/, float /*c*/) { return std::cos(a); }
float tangent(float a, float /*b*/, float /*c*/) { return std::tan(a); }
float arc_sine(float a, float /*b*/, float /*c*/) { return std::asin(clamp_between(a, -1, 1)); }
float arc_cosine(float a, float /*b*/, float /*c*/) { return std::acos(clamp_between(a, -1, 1)); }
float arc_tangent(float a, float /*b*/, float /*c*/) { return std::atan(a); }
// IEEE 754 has four answers at the origin, by the signs of the zeros.
float arc_tangent_2(float a, float b, float /*c*/)
{
    return a == 0.0f && b == 0.0f ? 0.0f : std::atan2(a, b);
}
float hyperbolic_sine(float a, float /*b*/, float /*c*/) { return std::sinh(a); }
float hyperbolic_cosine(float a, float /*b*/, float /*c*/) { return std::cosh(a); }
float hyperbolic_tangent(float a, float /*b*/, float /*c*/) { return std::tanh(a); }
float to_radians(float a, float /*b*/, float /*c*/) { return a / degrees_per_radian; }
float to_degrees(float a, float /*b*/, float /*c*/) { return a * degrees_per_radian; }

constexpr std::array<MathOperation, 41> operations{{
    {"ADD", 2, add},
    {"SUBTRACT", 2, subtract},
    {"MULTIPLY", 2, multiply},
    {"DIVIDE", 2, divide},
    {"MULTIPLY_ADD", 3, multiply_add},
    {"POWER", 2, power},
    {"LOGARITHM", 2, logarithm},
    {"SQRT", 1, square_root},
    {"INVERSE_SQRT", 1, inverse_square_root},
    {"ABSOLUTE", 1, absolute},
    {"EXPONENT", 1, exponent},
    {"MINIMUM", 2, minimum},
    {"MAXIMUM", 2, maximum},
    {"LESS_THAN", 2, less_than},
    {"GREATER_THAN", 2, greater_than},
    {"SIGN", 1, sign_of},
    {"COMPARE", 3, compare},
    {"SMOOTH_MIN", 3, smooth_minimum},
    {"SMOOTH_MAX", 3, smooth_maximum},
    {"ROUND", 1, round_half_up},
    {"FLOOR", 1, floor_of},
    {"CEIL", 1, ceiling},
    {"TRUNC", 1, truncate},
    {"FRACT", 1, fraction_of},
    {"MODULO", 2, modulo},
    {"FLOORED_MODULO", 2, floored_modulo},
    {"WRAP", 3, wrap},
    {"SNAP", 2, snap_to},
    {"PINGPONG", 2, ping_pong_of},
    {"SINE", 1, sine},
    {"COSINE", 1, cosine},
    {"TANGENT", 1, tangent},
    {"ARCSINE", 1, arc_sine},
    {"ARCCOSINE", 1, arc_cosine},
    {"ARCTANGENT", 1, arc_tangent},
    {"ARCTAN2", 2, arc_tangent_2},
    {"SINH", 1, hyperbolic_sine},
    {"COSH", 1, hyperbolic_cosine},
    {"TANH", 1, hyperbolic_tangent},
    {"RADIANS", 1, to_radians},
    {"DEGREES", 1, to_degrees},
}};

}  // namespace

const MathOperation& math_operation(std::string_view name)
{
    return row_named(std::span<const MathOperation>(operations), "operation", name);
}

}  // namespace eye_render
