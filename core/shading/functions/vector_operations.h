// The operations of the Vector Math node, under Blender's names.

#pragma once

#include "base/vector.h"

#include <string_view>

namespace eye_render {

struct VectorOperands {
    V3f a{0.0f};
    V3f b{0.0f};
    V3f c{0.0f};
    float scale = 0.0f;
};

struct VectorOperation {
    std::string_view name;
    int vectors = 1;  // that it reads: a, b, c
    bool reads_scale = false;
    bool is_number = false;  // the result is one number, in all three
    V3f (*apply)(const VectorOperands& in) = nullptr;
};

// Throws std::invalid_argument for a name that is none.
[[nodiscard]] const VectorOperation& vector_operation(std::string_view name);

// As it is where it has no length.
[[nodiscard]] V3f safe_normalized(const V3f& v);

// Component by component.
[[nodiscard]] V3f safe_divide(const V3f& a, const V3f& b);

}  // namespace eye_render
