// Input sockets, as the rows of node kinds list them.

#pragma once

#include "shading/node.h"

namespace eye_render {

[[nodiscard]] constexpr InputSocket number_input(std::string_view identifier, float value = 0.0f)
{
    return {identifier, SocketType::Number, NodeValue(value)};
}

[[nodiscard]] constexpr InputSocket vector_input(std::string_view identifier,
                                                 const NodeValue& value = NodeValue(0.0f))
{
    return {identifier, SocketType::Vector, value};
}

[[nodiscard]] constexpr InputSocket color_input(std::string_view identifier, float value)
{
    return {identifier, SocketType::Color, NodeValue(value)};
}

// The shading normal where nothing is linked.
[[nodiscard]] constexpr InputSocket normal_input(std::string_view identifier = "Normal")
{
    return {identifier, SocketType::Vector, NodeValue(0.0f), ImplicitInput::Normal};
}

}  // namespace eye_render
