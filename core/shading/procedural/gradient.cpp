#include "shading/procedural/gradient.h"

#include "shading/procedural/safe_float.h"

#include <cmath>
#include <numbers>

namespace eye_render {
namespace {

// From 1 at the origin to 0 on the unit sphere, where rounding is not to show.
[[nodiscard]] float inside_sphere(const V3f& p)
{
    return std::max(0.999999f - std::sqrt(p.dot(p)), 0.0f);
}

[[nodiscard]] float unbounded_gradient(const V3f& p, GradientType type)
{
    switch (type) {
    case GradientType::Linear: return p.x;
    case GradientType::Quadratic: {
        const float x = std::max(p.x, 0.0f);
        return x * x;
    }
    case GradientType::Easing: return smooth_step(p.x);
    case GradientType::Diagonal: return (p.x + p.y) * 0.5f;
    case GradientType::Spherical: return inside_sphere(p);
    case GradientType::QuadraticSphere: {
        const float inside = inside_sphere(p);
        return inside * inside;
    }
    case GradientType::Radial:
        return std::atan2(p.y, p.x) / (2.0f * std::numbers::pi_v<float>)+0.5f;
    }
    return 0.0f;
}

}  // namespace

float gradient_texture(const V3f& p, GradientType type)
{
    return unit_range(unbounded_gradient(p, type));
}

}  // namespace eye_render
