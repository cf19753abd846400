// One value node asked for one output at a hit. What is said of an input is constant; the others
// read what they read where nothing is linked.

#pragma once

#include "made_up_hit.h"

#include "shading/node_graph.h"

#include <initializer_list>
#include <map>
#include <string>

namespace eye_render::test {

struct AskedNode {
    std::string_view type;
    std::map<std::string, NodeOptions::Value> options{};
    std::map<std::string, NodeValue> inputs{};
    std::map<std::string, int> names{};  // of layers and attributes

    // Throws what the graph and the node throw for a name or an option. The outputs that are not
    // asked for are not wanted.
    [[nodiscard]] NodeValue operator()(std::string_view output, const Hit& hit) const
    {
        NodeGraph graph;
        const std::size_t number = graph.add(type, NodeOptions(options));
        for (const auto& [input, value] : inputs) {
            graph.set(number, input, value);
        }
        const std::size_t place = graph.output(number, output).output;
        const NodeGraph::Node& node = graph.node(number);
        AnyResources resources;
        resources.names = names;
        ProgramStep step;
        step.node = node.type->make_value(node.options, resources);
        step.output_count = node.type->outputs.size();
        step.wanted_outputs = 1u << place;
        step.wanted = {{.output = place, .value = 0}};
        for (std::size_t i = 0; i < node.inputs.size(); ++i) {
            const InputSocket& socket = node.type->inputs[i];
            const auto* value = std::get_if<NodeValue>(&node.inputs[i]);
            step.inputs.push_back(value != nullptr ? ProgramInput{.constant = *value}
                                                   : ProgramInput{.constant = socket.value,
                                                                  .implicit = socket.implicit});
        }
        const std::vector<ProgramStep> steps{std::move(step)};
        ProgramRun run(steps, 1, hit);
        return run.read({.step = 0, .value = 0});
    }
    [[nodiscard]] NodeValue operator()(std::string_view output,
                                       const HitAttributes& attributes,
                                       const ShadingPoint& point) const
    {
        const PathState path;
        return (*this)(output, {.point = point, .attributes = attributes, .path = path});
    }
};

}  // namespace eye_render::test
