// The rows of procedural_textures.cpp, by family, and what their nodes share.

#pragma once

#include "base/error.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/sockets.h"
#include "shading/procedural/point.h"

#include <array>

namespace eye_render {

// Where the texture is looked up: Blender's generated coordinates unless linked.
inline constexpr InputSocket texture_vector{"Vector", SocketType::Vector, NodeValue(0.0f),
                                            ImplicitInput::Generated};

inline constexpr InputSocket texture_scale = number_input("Scale", 5.0f);

inline constexpr std::array color_and_fac{OutputSocket{"Color", SocketType::Color},
                                          OutputSocket{"Fac"}};

[[nodiscard]] inline int dimensions_of(const NodeOptions& options, const std::string& name)
{
    return options.choice<int>(name, {{"3D", 3}, {"1D", 1}, {"2D", 2}, {"4D", 4}});
}

// An option that is a number. Throw std::invalid_argument for one out of range.
[[nodiscard]] inline float number_in_range(const NodeOptions& options,
                                           const char* name,
                                           double otherwise,
                                           double lowest,
                                           double highest)
{
    const double value = options.number(name, otherwise);
    require_range(name, value, lowest, highest, "");
    return static_cast<float>(value);
}

[[nodiscard]] inline int integer_in_range(const NodeOptions& options,
                                          const char* name,
                                          double otherwise,
                                          double lowest,
                                          double highest)
{
    return static_cast<int>(number_in_range(options, name, otherwise, lowest, highest));
}

// What the function says of the place in that many dimensions. One dimension is W alone, four are
// the vector and W.
template <typename Function>
auto in_dimensions(int dimensions,
                   const NodeInputs& in,
                   std::size_t vector_input,
                   std::size_t w_input,
                   const Function& function)
{
    if (dimensions == 1) {
        return function(Point<1>{{in.number(w_input)}});
    }
    const V3f v = in.vector(vector_input);
    if (dimensions == 2) {
        return function(Point<2>{{v.x, v.y}});
    }
    if (dimensions == 3) {
        return function(Point<3>{{v.x, v.y, v.z}});
    }
    return function(Point<4>{{v.x, v.y, v.z, in.number(w_input)}});
}

[[nodiscard]] NodeType noise_texture_node();
[[nodiscard]] NodeType white_noise_node();
[[nodiscard]] NodeType voronoi_texture_node();
[[nodiscard]] NodeType wave_texture_node();
[[nodiscard]] NodeType magic_texture_node();
[[nodiscard]] NodeType brick_texture_node();
[[nodiscard]] NodeType checker_texture_node();
[[nodiscard]] NodeType gradient_texture_node();
[[nodiscard]] NodeType gabor_texture_node();

}  // namespace eye_render
