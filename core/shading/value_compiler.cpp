#include "shading/value_compiler.h"

#include "shading/nowhere.h"

#include <algorithm>
#include <stdexcept>

namespace eye_render {

namespace {

[[nodiscard]] Conversion conversion_between(SocketType from, SocketType to)
{
    if (from == to) {
        return Conversion::None;
    }
    if (from == SocketType::Number) {
        return Conversion::Splat;
    }
    if (to == SocketType::Number) {
        return from == SocketType::Color ? Conversion::Luminance : Conversion::Mean;
    }
    return Conversion::None;
}

[[nodiscard]] std::vector<NodeValue> fold(ProgramStep& step)
{
    step.wanted_outputs = ~0u;
    std::vector<NodeValue> outputs(step.output_count, NodeValue(0.0f));
    const Nowhere nowhere;
    const std::vector<ProgramStep> no_steps;
    ProgramRun run(no_steps, 0, nowhere.hit());
    step.node->evaluate(NodeInputs(run, step), outputs);
    return outputs;
}

}  // namespace

void refuse_circle(const NodeGraph& graph, std::size_t node)
{
    throw std::invalid_argument("the links of node " + std::to_string(node) + " (" +
                                std::string(graph.node(node).type->name) + ") run in a circle");
}

ProgramInput ValueCompiler::linked(const NodeOutput& from, SocketType to)
{
    const NodeGraph::Node& node = graph_.node(from.node);
    const SocketType type = node.type->outputs[from.output].type;
    if (type == SocketType::Shader) {
        throw std::invalid_argument(std::string(node.type->name) +
                                    " is a shader; expected a value");
    }
    const Conversion conversion = conversion_between(type, to);
    const V3f weights = luminance_weights(resources_.working_space());
    const Compiled& compiled = compile(from.node);
    if (compiled.step == ProgramInput::none) {
        return {.constant = converted(compiled.constants[from.output], conversion, weights)};
    }
    if (node.type->outputs[from.output].reads_active_uv) {
        static_cast<void>(resources_.uv_layer(""));
    }
    return {.constant = weights,
            .step = compiled.step,
            .value = place_of(steps_[static_cast<std::size_t>(compiled.step)], from.output),
            .conversion = conversion};
}

int ValueCompiler::place_of(ProgramStep& step, std::size_t output)
{
    const auto known = std::ranges::find(step.wanted, output, &ProgramStep::Wanted::output);
    if (known != step.wanted.end()) {
        return known->value;
    }
    step.wanted_outputs |= 1u << output;
    step.wanted.push_back({.output = output, .value = value_count_});
    return value_count_++;
}

ProgramInput ValueCompiler::input_of(const NodeGraph::Node& node, std::size_t number)
{
    const InputSocket& socket = node.type->inputs[number];
    const NodeGraph::Source& source = node.inputs[number];
    if (const auto* from = std::get_if<NodeOutput>(&source)) {
        return linked(*from, socket.type);
    }
    if (const auto* value = std::get_if<NodeValue>(&source)) {
        return {.constant = *value};
    }
    if (socket.implicit == ImplicitInput::Uv) {
        static_cast<void>(resources_.uv_layer(""));
    }
    return {.constant = socket.value, .implicit = socket.implicit};
}

std::vector<ProgramInput> ValueCompiler::inputs_of(const NodeGraph::Node& node)
{
    std::vector<ProgramInput> inputs(node.type->inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (node.type->inputs[i].type != SocketType::Shader) {
            inputs[i] = input_of(node, i);
        }
    }
    return inputs;
}

const ValueCompiler::Compiled& ValueCompiler::compile(std::size_t number)
{
    Compiled& compiled = compiled_[number];
    const NodeGraph::Node& node = graph_.node(number);
    if (compiled.state == Compiled::State::Done) {
        return compiled;
    }
    if (compiled.state == Compiled::State::Begun) {
        refuse_circle(graph_, number);
    }
    compiled.state = Compiled::State::Begun;
    ProgramStep step{.inputs = inputs_of(node),
                     .node = node.made_value(resources_),
                     .output_count = node.type->outputs.size()};
    const bool is_constant =
        !node.type->reads_hit && std::ranges::all_of(step.inputs, &ProgramInput::is_constant);
    if (is_constant) {
        compiled.constants = fold(step);
    } else {
        step.varies_in_space = (node.type->reads_hit && !node.type->reads_object_alone) ||
                               std::ranges::any_of(step.inputs, [](const ProgramInput& input) {
                                   return input.implicit != ImplicitInput::None;
                               });
        compiled.step = static_cast<int>(steps_.size());
        steps_.push_back(std::move(step));
    }
    compiled.state = Compiled::State::Done;
    return compiled;
}

}  // namespace eye_render
