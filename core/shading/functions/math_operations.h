// The operations of the Math node, under Blender's names.

#pragma once

#include <string_view>

namespace eye_render {

struct MathOperation {
    std::string_view name;
    int operands = 1;  // that it reads
    float (*apply)(float a, float b, float c) = nullptr;
};

// Throws std::invalid_argument for a name that is none.
[[nodiscard]] const MathOperation& math_operation(std::string_view name);

}  // namespace eye_render
