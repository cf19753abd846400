// The solid angle of a rectangle seen from a point, sampled uniformly: Urena, Fajardo and King
// 2013, "An Area-Preserving Parametrization for Spherical Rectangles". Density 1 / solid_angle().

#pragma once

#include "base/vector.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace eye_render {

class SphericalRectangle {
public:
    // The corner is relative to the viewing point; the axes are unit and orthogonal, the lengths
    // positive. The viewing point must not lie in the rectangle's plane.
    SphericalRectangle(const V3f& corner,
                       const V3f& axis_x,
                       const V3f& axis_y,
                       float length_x,
                       float length_y)
        : axis_x_(axis_x), axis_y_(axis_y), axis_z_(axis_x.cross(axis_y)), x0_(corner.dot(axis_x)),
          y0_(corner.dot(axis_y)), z0_(corner.dot(axis_z_)), x1_(x0_ + length_x),
          y1_(y0_ + length_y)
    {
        if (z0_ > 0.0f) {
            z0_ = -z0_;
            axis_z_ = -axis_z_;
        }
        // z components of the unit normals of the four planes through the point and an edge.
        const float z2 = z0_ * z0_;
        b0_ = -y0_ / std::sqrt(z2 + y0_ * y0_);
        b1_ = y1_ / std::sqrt(z2 + y1_ * y1_);
        const float nx1 = x1_ / std::sqrt(z2 + x1_ * x1_);
        const float nx0 = -x0_ / std::sqrt(z2 + x0_ * x0_);
        const float g0 = std::acos(-b0_ * nx1);
        const float g1 = std::acos(-nx1 * b1_);
        const float g2 = std::acos(-b1_ * nx0);
        const float g3 = std::acos(-nx0 * b0_);
        k_ = 2.0f * std::numbers::pi_v<float> - g2 - g3;
        solid_angle_ = g0 + g1 - k_;
    }

    [[nodiscard]] float solid_angle() const { return solid_angle_; }

    // A point on the rectangle, relative to the viewing point.
    [[nodiscard]] V3f sample(const V2f& u) const
    {
        const float au = u.x * solid_angle_ + k_;
        const float sin_au = std::sin(au);
        const float fu = (std::cos(au) * b0_ - b1_) / sin_au;
        const float cu =
            std::clamp(std::copysign(1.0f / std::sqrt(fu * fu + b0_ * b0_), fu), -1.0f, 1.0f);
        // 1 - cu^2 may round to zero; the clamp below then picks the edge that it stands for.
        const float sin_cu = std::sqrt(std::max(1e-12f, 1.0f - cu * cu));
        const float x = std::clamp(-cu * z0_ / sin_cu, x0_, x1_);
        const float d2 = x * x + z0_ * z0_;
        const float h0 = y0_ / std::sqrt(d2 + y0_ * y0_);
        const float h1 = y1_ / std::sqrt(d2 + y1_ * y1_);
        const float h = h0 + u.y * (h1 - h0);
        const float y = h * std::sqrt(d2 / std::max(1e-12f, 1.0f - h * h));
        return axis_x_ * x + axis_y_ * std::clamp(y, y0_, y1_) + axis_z_ * z0_;
    }

private:
    V3f axis_x_, axis_y_, axis_z_;
    float x0_, y0_, z0_, x1_, y1_;
    float b0_, b1_, k_, solid_angle_;
};

}  // namespace eye_render
