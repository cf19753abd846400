// One node evaluated alone, its options and inputs by name.

#pragma once

#include "made_up_hit.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace eye_render::test {

using Options = std::map<std::string, NodeOptions::Value>;

class NodeTrial {
public:
    // Throws what the node throws for an option.
    explicit NodeTrial(const NodeType& type, Options options = {}) : type_(type)
    {
        for (const auto& option : options) {
            EXPECT_NE(std::ranges::find(type.options, option.first), type.options.end())
                << type.name << " has no option " << option.first;
        }
        AnyResources resources;
        step_.node = type.make_value(NodeOptions(std::move(options)), resources);
        step_.output_count = type.outputs.size();
        step_.wanted_outputs = ~0u;
        for (const InputSocket& socket : type.inputs) {
            step_.inputs.push_back({.constant = socket.value, .implicit = socket.implicit});
        }
    }

    NodeTrial& set(std::string_view input, const NodeValue& value)
    {
        step_.inputs[place_of(type_.inputs, input)] = {.constant = value};
        return *this;
    }
    NodeTrial& set(std::string_view input, float value) { return set(input, NodeValue(value)); }

    [[nodiscard]] NodeValue operator()(std::string_view output,
                                       const HitAttributes& attributes = MadeUpHit(),
                                       const PathState& path = {}) const
    {
        const ShadingPoint point{
            .wo = V3f(0.0f, 0.0f, 1.0f), .ng = V3f(0.0f, 0.0f, 1.0f), .ns = V3f(0.0f, 0.0f, 1.0f)};
        const Hit hit{.point = point, .attributes = attributes, .path = path};
        const std::vector<ProgramStep> no_steps;
        ProgramRun run(no_steps, 0, hit);
        std::vector<NodeValue> outputs(type_.outputs.size(), NodeValue(0.0f));
        step_.node->evaluate(NodeInputs(run, step_), outputs);
        return outputs[place_of(type_.outputs, output)];
    }

private:
    template <typename Sockets>
    [[nodiscard]] std::size_t place_of(const Sockets& sockets, std::string_view identifier) const
    {
        for (std::size_t i = 0; i < sockets.size(); ++i) {
            if (sockets[i].identifier == identifier) {
                return i;
            }
        }
        throw std::invalid_argument(std::string(type_.name) + " has no socket " +
                                    std::string(identifier));
    }

    const NodeType& type_;
    ProgramStep step_;
};

}  // namespace eye_render::test
