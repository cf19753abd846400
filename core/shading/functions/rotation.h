// Rotations of vectors, and the Mapping node made of them. Angles in radians, counterclockwise
// seen against the axis; Euler angles turn about X first, then Y, then Z, each a fixed axis.

#pragma once

#include "base/vector.h"
#include "shading/functions/vector_operations.h"

#include <cmath>

namespace eye_render {

class EulerRotation {
public:
    explicit EulerRotation(const V3f& angles_rad)
    {
        const float cx = std::cos(angles_rad.x), sx = std::sin(angles_rad.x);
        const float cy = std::cos(angles_rad.y), sy = std::sin(angles_rad.y);
        const float cz = std::cos(angles_rad.z), sz = std::sin(angles_rad.z);
        x_ = V3f(cy * cz, cy * sz, -sy);
        y_ = V3f(sy * sx * cz - cx * sz, sy * sx * sz + cx * cz, cy * sx);
        z_ = V3f(sy * cx * cz + sx * sz, sy * cx * sz - sx * cz, cy * cx);
    }

    [[nodiscard]] V3f turned(const V3f& v) const { return x_ * v.x + y_ * v.y + z_ * v.z; }
    [[nodiscard]] V3f turned_back(const V3f& v) const { return {x_.dot(v), y_.dot(v), z_.dot(v)}; }

private:
    V3f x_, y_, z_;  // where the axes go
};

// Rodrigues' formula; `axis` is unit.
[[nodiscard]] inline V3f turned_about(const V3f& v, const V3f& axis, float angle_rad)
{
    const float c = std::cos(angle_rad);
    return v * c + axis.cross(v) * std::sin(angle_rad) + axis * (axis.dot(v) * (1.0f - c));
}

// What is mapped: a point, the texture it looks up (the inverse of Point), a direction, or a
// normal.
enum class MappingKind { Point, Texture, Vector, Normal };

struct Mapping {
    V3f location{0.0f};
    V3f rotation_rad{0.0f};
    V3f scale{1.0f};
};

[[nodiscard]] inline V3f mapped(MappingKind kind, const V3f& v, const Mapping& mapping)
{
    const EulerRotation rotation(mapping.rotation_rad);
    switch (kind) {
    case MappingKind::Texture:
        return safe_divide(rotation.turned_back(v - mapping.location), mapping.scale);
    case MappingKind::Vector: return rotation.turned(v * mapping.scale);
    case MappingKind::Normal:
        return safe_normalized(rotation.turned(safe_divide(v, mapping.scale)));
    default: return rotation.turned(v * mapping.scale) + mapping.location;
    }
}

}  // namespace eye_render
