// From a graph of nodes to a program: what the outputs depend on, in the order of need, with
// everything that is the same at every hit computed now.

#include "shading/nowhere.h"
#include "shading/program.h"

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

}  // namespace

class ProgramCompiler {
public:
    ProgramCompiler(const NodeGraph& graph, NodeResources& resources, ShaderProgram& program)
        : graph_(graph), resources_(resources), program_(program), compiled_(graph.size()),
          is_on_the_way_(graph.size(), false)
    {
    }

    void add_surface(const NodeOutput& output)
    {
        add_closures(output, 1.0f, {});
        int lobes = 0;
        for (const ProgramLeaf& leaf : program_.leaves_) {
            lobes += leaf.facts.lobes;
            program_.may_be_transparent_ |= leaf.facts.may_be_transparent;
            program_.may_emit_ |= leaf.facts.may_emit;
        }
        if (lobes > Bsdf::capacity) {
            throw std::invalid_argument("a mix of shaders has " + std::to_string(lobes) +
                                        " lobes; expected 0 to " + std::to_string(Bsdf::capacity));
        }
    }

    void add_displacement(const NodeOutput& output)
    {
        const ProgramInput input = linked(output, SocketType::Vector);
        // A constant displacement lifts all of the surface alike and bends no normal.
        if (!input.is_constant()) {
            program_.displacement_ = input;
            program_.has_displacement_ = true;
        }
    }

private:
    struct Compiled {
        enum class State { New, Begun, Done } state = State::New;
        int step = ProgramInput::none;
        std::vector<NodeValue> constants;  // the outputs of a folded node
    };

    [[nodiscard]] static SocketType type_of(const NodeGraph::Node& node, std::size_t output)
    {
        return node.type->outputs[output].type;
    }

    // The input that reads another node's output as a socket of type `to`.
    ProgramInput linked(const NodeOutput& from, SocketType to)
    {
        const NodeGraph::Node& node = graph_.node(from.node);
        const SocketType type = type_of(node, from.output);
        if (type == SocketType::Shader) {
            throw std::invalid_argument(std::string(node.type->name) +
                                        " is a shader; expected a value");
        }
        const Conversion conversion = conversion_between(type, to);
        const Compiled& compiled = compile(from.node);
        if (compiled.step == ProgramInput::none) {
            return {.constant = converted(compiled.constants[from.output], conversion)};
        }
        ProgramStep& step = program_.steps_[static_cast<std::size_t>(compiled.step)];
        step.wanted_outputs |= 1u << from.output;
        if (node.type->outputs[from.output].reads_active_uv) {
            static_cast<void>(resources_.uv_layer(""));
        }
        return {.step = compiled.step,
                .value = step.first_value + static_cast<int>(from.output),
                .conversion = conversion};
    }

    ProgramInput input_of(const NodeGraph::Node& node, std::size_t number)
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

    [[nodiscard]] std::vector<ProgramInput> inputs_of(const NodeGraph::Node& node)
    {
        std::vector<ProgramInput> inputs(node.type->inputs.size());
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            if (node.type->inputs[i].type != SocketType::Shader) {
                inputs[i] = input_of(node, i);
            }
        }
        return inputs;
    }

    [[noreturn]] void refuse_circle(std::size_t number) const
    {
        throw std::invalid_argument("the links of node " + std::to_string(number) + " (" +
                                    std::string(graph_.node(number).type->name) +
                                    ") run in a circle");
    }

    const Compiled& compile(std::size_t number)
    {
        Compiled& compiled = compiled_[number];
        const NodeGraph::Node& node = graph_.node(number);
        if (compiled.state == Compiled::State::Done) {
            return compiled;
        }
        if (compiled.state == Compiled::State::Begun) {
            refuse_circle(number);
        }
        compiled.state = Compiled::State::Begun;
        ProgramStep step{.inputs = inputs_of(node),
                         .node = node.type->make_value(node.options, resources_),
                         .first_value = program_.value_count_,
                         .value_count = static_cast<int>(node.type->outputs.size())};
        const bool is_constant =
            !node.type->reads_hit && std::ranges::all_of(step.inputs, &ProgramInput::is_constant);
        if (is_constant) {
            compiled.constants = fold(step);
        } else {
            program_.value_count_ += step.value_count;
            compiled.step = static_cast<int>(program_.steps_.size());
            program_.steps_.push_back(std::move(step));
        }
        compiled.state = Compiled::State::Done;
        return compiled;
    }

    [[nodiscard]] static std::vector<NodeValue> fold(ProgramStep& step)
    {
        step.wanted_outputs = ~0u;
        std::vector<NodeValue> outputs(static_cast<std::size_t>(step.value_count),
                                       NodeValue(0.0f));
        const Nowhere nowhere;
        const std::vector<ProgramStep> no_steps;
        ProgramRun run(no_steps, 0, nowhere.hit());
        step.node->evaluate(NodeInputs(run, step), outputs);
        return outputs;
    }

    void add_closures(const NodeOutput& output,
                      float constant_weight,
                      const std::vector<ProgramLeaf::Factor>& factors)
    {
        const NodeGraph::Node& node = graph_.node(output.node);
        if (is_on_the_way_[output.node]) {
            refuse_circle(output.node);
        }
        if (++depth_ > deepest) {
            throw std::invalid_argument("mixed shaders are nested more than " +
                                        std::to_string(deepest) + " deep");
        }
        is_on_the_way_[output.node] = true;
        switch (node.type->role) {
        case NodeRole::MixShader: add_mix(node, constant_weight, factors); break;
        case NodeRole::AddShader:
            add_shader(node, 0, constant_weight, factors);
            add_shader(node, 1, constant_weight, factors);
            break;
        case NodeRole::Closure:
            add_leaf(node.type->make_closure(node.options, resources_), inputs_of(node),
                     constant_weight, factors);
            break;
        case NodeRole::Value: add_shining(output, constant_weight, factors); break;
        }
        is_on_the_way_[output.node] = false;
        --depth_;
    }

    void add_shader(const NodeGraph::Node& node,
                    std::size_t input,
                    float constant_weight,
                    const std::vector<ProgramLeaf::Factor>& factors)
    {
        if (const auto* from = std::get_if<NodeOutput>(&node.inputs[input])) {
            add_closures(*from, constant_weight, factors);
        }
    }

    void add_mix(const NodeGraph::Node& node,
                 float constant_weight,
                 const std::vector<ProgramLeaf::Factor>& factors)
    {
        const ProgramInput factor = input_of(node, 0);
        for (const bool is_rest : {true, false}) {
            const std::size_t shader = is_rest ? 1 : 2;
            if (factor.is_constant()) {
                const float share = std::clamp(factor.constant.x, 0.0f, 1.0f);
                const float weight = constant_weight * (is_rest ? 1.0f - share : share);
                if (weight > 0.0f) {
                    add_shader(node, shader, weight, factors);
                }
            } else {
                std::vector<ProgramLeaf::Factor> more = factors;
                more.push_back({.input = factor, .is_rest = is_rest});
                add_shader(node, shader, constant_weight, more);
            }
        }
    }

    // A colour where a shader is asked for shines, as in Blender.
    void add_shining(const NodeOutput& output,
                     float constant_weight,
                     const std::vector<ProgramLeaf::Factor>& factors)
    {
        const NodeType& emission = *node_type_named("EMISSION");
        NodeGraph shining;
        const std::size_t number = shining.add("EMISSION");
        std::vector<ProgramInput> inputs = inputs_of(shining.node(number));
        inputs[0] = linked(output, SocketType::Color);
        add_leaf(emission.make_closure({}, resources_), std::move(inputs), constant_weight,
                 factors);
    }

    void add_leaf(std::unique_ptr<const ClosureNode> closure,
                  std::vector<ProgramInput> inputs,
                  float constant_weight,
                  const std::vector<ProgramLeaf::Factor>& factors)
    {
        if (program_.leaves_.size() == most_leaves) {
            throw std::invalid_argument("a mix of shaders has more than " +
                                        std::to_string(most_leaves) + " shaders");
        }
        std::vector<std::optional<NodeValue>> constants;
        constants.reserve(inputs.size());
        for (const ProgramInput& input : inputs) {
            constants.push_back(input.is_constant() ? std::optional(input.constant)
                                                    : std::nullopt);
        }
        const ClosureFacts facts = closure->facts(constants);
        program_.leaves_.push_back({.step = {.inputs = std::move(inputs)},
                                    .closure = std::move(closure),
                                    .constant_weight = constant_weight,
                                    .factors = factors,
                                    .facts = facts});
    }

    static constexpr int deepest = 64;
    // Ways to a closure double at every level where both inputs of a mix are linked to one node.
    static constexpr std::size_t most_leaves = 256;

    const NodeGraph& graph_;
    NodeResources& resources_;
    ShaderProgram& program_;
    std::vector<Compiled> compiled_;
    std::vector<bool> is_on_the_way_;  // to the closure that is added
    int depth_ = 0;
};

ShaderProgram::ShaderProgram(const NodeGraph& graph,
                             const std::optional<NodeOutput>& surface,
                             const std::optional<NodeOutput>& displacement,
                             NodeResources& resources)
{
    ProgramCompiler compiler(graph, resources, *this);
    if (surface) {
        compiler.add_surface(*surface);
    }
    if (displacement) {
        compiler.add_displacement(*displacement);
    }
}

}  // namespace eye_render
