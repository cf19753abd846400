// The solid angle of a triangle seen from a point, sampled uniformly: Arvo 1995, "Stratified
// Sampling of Spherical Triangles". Density 1 / solid_angle().

#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

class SphericalTriangle {
public:
    // Corners relative to the viewing point, none of them there.
    SphericalTriangle(const V3f& p0, const V3f& p1, const V3f& p2)
        : a_(p0.normalized()), b_(p1.normalized()), c_(p2.normalized()), cos_b_(a_.dot(c_)),
          cos_c_(a_.dot(b_))
    {
        // Van Oosterom and Strackee 1983, "The Solid Angle of a Plane Triangle".
        solid_angle_ =
            2.0f * std::atan2(std::abs(a_.dot(b_.cross(c_))), 1.0f + b_.dot(c_) + cos_b_ + cos_c_);
    }

    // Not negative; 0 of a triangle seen edge-on.
    [[nodiscard]] float solid_angle() const { return solid_angle_; }

    // A unit direction, u in [0, 1)^2. Only of a triangle with a solid angle.
    [[nodiscard]] V3f sample(const V2f& u) const
    {
        const V3f across_b = a_.cross(b_).normalized();
        const V3f across_c = a_.cross(c_).normalized();
        // The angle at corner a.
        const float cos_alpha = std::clamp(across_b.dot(across_c), -1.0f, 1.0f);
        const float alpha_rad = std::acos(cos_alpha);
        const float sin_alpha = std::sin(alpha_rad);
        // The side from a to c is cut off where the part has its share of the area.
        const float phi_rad = u.x * solid_angle_ - alpha_rad;
        const float s = std::sin(phi_rad);
        const float t = std::cos(phi_rad);
        const float p = t - cos_alpha;
        const float q = s + sin_alpha * cos_c_;
        const float divisor = (q * s + p * t) * sin_alpha;
        const float cos_cut =
            divisor != 0.0f ? std::clamp(((q * t - p * s) * cos_alpha - q) / divisor, -1.0f, 1.0f)
                            : 1.0f;
        const V3f cut = turned(a_, c_, cos_cut);
        return turned(b_, cut, 1.0f - u.y * (1.0f - cut.dot(b_)));
    }

private:
    // At that cosine from `from`, on the arc to `to`.
    [[nodiscard]] static V3f turned(const V3f& from, const V3f& to, float cosine)
    {
        const V3f away = (to - from * to.dot(from)).normalized();
        return from * cosine + away * std::sqrt(std::max(0.0f, 1.0f - cosine * cosine));
    }

    V3f a_, b_, c_;
    float cos_b_;  // of the side from a to c
    float cos_c_;  // and from a to b
    float solid_angle_;
};

}  // namespace eye_render
