// The values that a graph's closures read, as steps of a program: what they depend on, in the
// order of need, with everything that is the same at every hit computed now.

#pragma once

#include "shading/program.h"

#include <vector>

namespace eye_render {

class ValueCompiler {
public:
    // Appends to `steps`, and counts the values that they give.
    ValueCompiler(const NodeGraph& graph,
                  NodeResources& resources,
                  std::vector<ProgramStep>& steps,
                  int& value_count)
        : graph_(graph), resources_(resources), steps_(steps), value_count_(value_count),
          compiled_(graph.size())
    {
    }

    // The input that reads another node's output as a socket of type `to`. Throws
    // std::invalid_argument for a shader, or where links run in a circle.
    ProgramInput linked(const NodeOutput& from, SocketType to);

    // Those of a node; a shader's are left empty.
    ProgramInput input_of(const NodeGraph::Node& node, std::size_t number);
    [[nodiscard]] std::vector<ProgramInput> inputs_of(const NodeGraph::Node& node);

private:
    struct Compiled {
        enum class State { New, Begun, Done } state = State::New;
        int step = ProgramInput::none;
        std::vector<NodeValue> constants;  // the outputs of a folded node
    };

    const Compiled& compile(std::size_t number);
    // Of one of the step's outputs among the values of a run; from now on it is wanted.
    int place_of(ProgramStep& step, std::size_t output);

    const NodeGraph& graph_;
    NodeResources& resources_;
    std::vector<ProgramStep>& steps_;
    int& value_count_;
    std::vector<Compiled> compiled_;
};

[[noreturn]] void refuse_circle(const NodeGraph& graph, std::size_t node);

}  // namespace eye_render
