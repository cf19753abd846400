// How value nodes are made, and the rows that say so.

#pragma once

#include "shading/node.h"

#include <memory>
#include <span>

namespace eye_render {

// A node without options: a function of inputs and hit.
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

// For NodeType::make_value: the node is made from its options.
template <typename Node>
[[nodiscard]] std::unique_ptr<const ValueNode> make_from_options(const NodeOptions& options,
                                                                 NodeResources& /*resources*/)
{
    return std::make_unique<Node>(options);
}

// What a node's outputs depend on besides its options.
enum class Reads : std::uint8_t { InputsAlone, Object, Hit };

[[nodiscard]] inline NodeType value_node(std::string_view name,
                                         Reads reads,
                                         std::span<const InputSocket> inputs,
                                         std::span<const OutputSocket> outputs,
                                         decltype(NodeType::make_value) make,
                                         std::span<const std::string_view> options = {})
{
    return {.name = name,
            .inputs = inputs,
            .outputs = outputs,
            .options = options,
            .reads_hit = reads != Reads::InputsAlone,
            .reads_object_alone = reads == Reads::Object,
            .make_value = make};
}

}  // namespace eye_render
