// Nodes without options: a function of inputs and hit.

#pragma once

#include "shading/node.h"

#include <memory>
#include <span>

namespace eye_render {

template <void (*function)(const NodeInputs&, std::span<NodeValue>)>
class FunctionNode final : public ValueNode {
public:
    void evaluate(const NodeInputs& in, std::span<NodeValue> outputs) const override
    {
        function(in, outputs);
    }
};

// For NodeType::make_value.
template <void (*function)(const NodeInputs&, std::span<NodeValue>)>
[[nodiscard]] std::unique_ptr<const ValueNode> make_function_node(const NodeOptions& /*options*/,
                                                                  NodeResources& /*resources*/)
{
    return std::make_unique<FunctionNode<function>>();
}

// A node that reads the hit.
[[nodiscard]] inline NodeType hit_reader(std::string_view name,
                                         std::span<const InputSocket> inputs,
                                         std::span<const OutputSocket> outputs,
                                         decltype(NodeType::make_value) make,
                                         std::span<const std::string_view> options = {})
{
    return {.name = name,
            .inputs = inputs,
            .outputs = outputs,
            .options = options,
            .reads_hit = true,
            .make_value = make};
}

}  // namespace eye_render
