// An option that is a vector or a colour.

#pragma once

#include "base/vector.h"
#include "shading/node_options.h"

namespace eye_render {

// Three numbers, or four of which the last is not read. Throws std::invalid_argument for less.
[[nodiscard]] inline V3f vector_option(const NodeOptions& options,
                                       const char* name,
                                       const V3f& otherwise)
{
    const std::vector<float> value = options.numbers(name);
    if (value.empty()) {
        return otherwise;
    }
    if (value.size() < 3) {
        throw std::invalid_argument(std::string(name) + " has " + std::to_string(value.size()) +
                                    " numbers; expected 3 or 4");
    }
    return {value[0], value[1], value[2]};
}

}  // namespace eye_render
