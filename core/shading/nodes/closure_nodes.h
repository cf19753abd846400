// The rows of closures.cpp, by family, and what their nodes share.

#pragma once

#include "shading/nodes/sockets.h"

#include <algorithm>
#include <array>
#include <memory>
#include <type_traits>

namespace eye_render {

// The one output of every surface closure.
inline constexpr auto bsdf_output = std::to_array<OutputSocket>({{"BSDF", SocketType::Shader}});

// Zero where nothing is linked.
[[nodiscard]] constexpr InputSocket tangent_input() { return vector_input("Tangent"); }

// The tangent that is linked or, where none is, that of circles around the object's own z, as
// Blender's Tangent node gives it.
[[nodiscard]] V3f tangent_input_value(const NodeInputs& in, std::size_t input);

// For NodeType::make_closure: the node is made from its options and, if it asks for that, the
// space that colours are in.
template <typename Node>
[[nodiscard]] std::unique_ptr<const ClosureNode> make_closure(const NodeOptions& options,
                                                              NodeResources& resources)
{
    if constexpr (std::is_constructible_v<Node, const NodeOptions&, WorkingSpace>) {
        return std::make_unique<Node>(options, resources.working_space());
    } else {
        return std::make_unique<Node>(options);
    }
}

template <typename Node>
[[nodiscard]] NodeType closure_type(std::string_view name,
                                    std::span<const InputSocket> inputs,
                                    std::span<const OutputSocket> outputs = bsdf_output,
                                    std::span<const std::string_view> options = {})
{
    return {.name = name,
            .inputs = inputs,
            .outputs = outputs,
            .options = options,
            .role = NodeRole::Closure,
            .reads_hit = true,
            .make_closure = &make_closure<Node>};
}

// True where the input is known not to be more than zero, in any colour.
[[nodiscard]] inline bool is_constantly_zero(ConstantInputs constants, std::size_t input)
{
    const std::optional<NodeValue>& value = constants[input];
    return value && !(std::max({value->x, value->y, value->z}) > 0.0f);
}

// The method that an option names, by Blender's names.
[[nodiscard]] LobeKind subsurface_method(const NodeOptions& options, const std::string& name);

[[nodiscard]] NodeType principled_node();
[[nodiscard]] NodeType diffuse_node();
[[nodiscard]] NodeType translucent_node();
[[nodiscard]] NodeType toon_node();
[[nodiscard]] NodeType sheen_node();
[[nodiscard]] NodeType subsurface_node();
[[nodiscard]] NodeType glossy_node();
[[nodiscard]] NodeType glass_node();
[[nodiscard]] NodeType refraction_node();
[[nodiscard]] NodeType metallic_node();
[[nodiscard]] NodeType emission_node();
[[nodiscard]] NodeType background_node();
[[nodiscard]] NodeType transparent_node();
[[nodiscard]] NodeType holdout_node();
[[nodiscard]] NodeType hair_node();
[[nodiscard]] NodeType principled_hair_node();
[[nodiscard]] NodeType volume_absorption_node();
[[nodiscard]] NodeType volume_scatter_node();
[[nodiscard]] NodeType volume_coefficients_node();
[[nodiscard]] NodeType principled_volume_node();

}  // namespace eye_render
