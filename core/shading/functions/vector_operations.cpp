#include "shading/functions/vector_operations.h"

#include "shading/functions/named_rows.h"
#include "shading/functions/safe_math.h"

#include <array>
#include <cmath>

namespace eye_render {

namespace {

template <typename Function>
[[nodiscard]] V3f each(Function f, const V3f& a)
{
    return {f(a.x), f(a.y), f(a.z)};
}

template <typename Function>
[[nodiscard]] V3f each(Function f, const V3f& a, const V3f& b)
{
    return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}

// Plain: Imath's own scales tiny vectors up first, and Blender's is 0 where the squares are.
[[nodiscard]] float length(const V3f& v) { return std::sqrt(v.dot(v)); }

V3f add(const VectorOperands& in) { return in.a + in.b; }
V3f subtract(const VectorOperands& in) { return in.a - in.b; }
V3f multiply(const VectorOperands& in) { return in.a * in.b; }
V3f divide(const VectorOperands& in) { return safe_divide(in.a, in.b); }
V3f multiply_add(const VectorOperands& in) { return in.a * in.b + in.c; }
V3f cross(const VectorOperands& in) { return in.a.cross(in.b); }

V3f project(const VectorOperands& in)
{
    const float squared = in.b.dot(in.b);
    return squared != 0.0f ? in.b * (in.a.dot(in.b) / squared) : V3f(0.0f);
}

V3f reflect(const VectorOperands& in)
{
    const V3f normal = safe_normalized(in.b);
    return in.a - normal * (2.0f * in.a.dot(normal));
}

// `scale` is the ratio of indices, before over behind; total reflection gives nothing.
V3f refract(const VectorOperands& in)
{
    const V3f normal = safe_normalized(in.b);
    const float cosine = normal.dot(in.a);
    const float squared = 1.0f - in.scale * in.scale * (1.0f - cosine * cosine);
    return squared < 0.0f ? V3f(0.0f)
                          : in.a * in.scale - normal * (in.scale * cosine + std::sqrt(squared));
}

V3f face_forward(const VectorOperands& in) { return in.c.dot(in.b) < 0.0f ? in.a : -in.a; }

V3f dot_product(const VectorOperands& in) { return V3f(in.a.dot(in.b)); }
V3f distance(const VectorOperands& in) { return V3f(length(in.a - in.b)); }
V3f length_of(const VectorOperands& in) { return V3f(length(in.a)); }
V3f scale(const VectorOperands& in) { return in.a * in.scale; }
V3f normalize(const VectorOperands& in) { return safe_normalized(in.a); }

V3f absolute(const VectorOperands& in)
{
    return each([](float x) { return std::abs(x); }, in.a);
}
V3f power(const VectorOperands& in) { return each(safe_power, in.a, in.b); }
V3f sign_of(const VectorOperands& in) { return each(sign, in.a); }
V3f minimum(const VectorOperands& in)
{
    return each([](float x, float y) { return x < y ? x : y; }, in.a, in.b);
}
V3f maximum(const VectorOperands& in)
{
    return each([](float x, float y) { return x > y ? x : y; }, in.a, in.b);
}
V3f round_half_up(const VectorOperands& in)
{
    return each([](float x) { return std::floor(x + 0.5f); }, in.a);
}
V3f floor_of(const VectorOperands& in)
{
    return each([](float x) { return std::floor(x); }, in.a);
}
V3f ceiling(const VectorOperands& in)
{
    return each([](float x) { return std::ceil(x); }, in.a);
}
V3f fraction_of(const VectorOperands& in) { return each(fraction, in.a); }
V3f modulo(const VectorOperands& in) { return each(safe_modulo, in.a, in.b); }
V3f wrap_between(const VectorOperands& in)
{
    return {wrap(in.a.x, in.b.x, in.c.x), wrap(in.a.y, in.b.y, in.c.y),
            wrap(in.a.z, in.b.z, in.c.z)};
}
V3f snap_to(const VectorOperands& in) { return each(snap, in.a, in.b); }
V3f sine(const VectorOperands& in)
{
    return each([](float x) { return std::sin(x); }, in.a);
}
V3f cosine(const VectorOperands& in)
{
    return each([](float x) { return std::cos(x); }, in.a);
}
V3f tangent(const VectorOperands& in)
{
    return each([](float x) { return std::tan(x); }, in.a);
}

constexpr std::array<VectorOperation, 30> operations{{
    {"ADD", 2, false, false, add},
    {"SUBTRACT", 2, false, false, subtract},
    {"MULTIPLY", 2, false, false, multiply},
    {"DIVIDE", 2, false, false, divide},
    {"MULTIPLY_ADD", 3, false, false, multiply_add},
    {"CROSS_PRODUCT", 2, false, false, cross},
    {"PROJECT", 2, false, false, project},
    {"REFLECT", 2, false, false, reflect},
    {"REFRACT", 2, true, false, refract},
    {"FACEFORWARD", 3, false, false, face_forward},
    {"DOT_PRODUCT", 2, false, true, dot_product},
    {"DISTANCE", 2, false, true, distance},
    {"LENGTH", 1, false, true, length_of},
    {"SCALE", 1, true, false, scale},
    {"NORMALIZE", 1, false, false, normalize},
    {"ABSOLUTE", 1, false, false, absolute},
    {"POWER", 2, false, false, power},
    {"SIGN", 1, false, false, sign_of},
    {"MINIMUM", 2, false, false, minimum},
    {"MAXIMUM", 2, false, false, maximum},
    {"ROUND", 1, false, false, round_half_up},
    {"FLOOR", 1, false, false, floor_of},
    {"CEIL", 1, false, false, ceiling},
    {"FRACTION", 1, false, false, fraction_of},
    {"MODULO", 2, false, false, modulo},
    {"WRAP", 3, false, false, wrap_between},
    {"SNAP", 2, false, false, snap_to},
    {"SINE", 1, false, false, sine},
    {"COSINE", 1, false, false, cosine},
    {"TANGENT", 1, false, false, tangent},
}};

}  // namespace

const VectorOperation& vector_operation(std::string_view name)
{
    return row_named(std::span<const VectorOperation>(operations), "operation", name);
}

V3f safe_normalized(const V3f& v)
{
    const float l = length(v);
    return l != 0.0f ? v * (1.0f / l) : v;
}

V3f safe_divide(const V3f& a, const V3f& b)
{
    return {safe_divide(a.x, b.x), safe_divide(a.y, b.y), safe_divide(a.z, b.z)};
}

}  // namespace eye_render
