// From a graph of nodes to a program: the closures that its output mixes, each with its weight.

#include "shading/program.h"
#include "shading/value_compiler.h"

#include <algorithm>
#include <stdexcept>

namespace eye_render {

class ProgramCompiler {
public:
    ProgramCompiler(const NodeGraph& graph, NodeResources& resources, ShaderProgram& program)
        : graph_(graph), resources_(resources), program_(program),
          values_(graph, resources, program.steps_, program.value_count_),
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
            if (const auto normal = leaf.facts.subsurface_normal) {
                program_.bends_subsurface_ |=
                    leaf.step.inputs[*normal].implicit != ImplicitInput::Normal;
            }
        }
        if (lobes > Bsdf::capacity) {
            throw std::invalid_argument("a mix of shaders has " + std::to_string(lobes) +
                                        " lobes; expected 0 to " + std::to_string(Bsdf::capacity));
        }
    }

    void add_displacement(const NodeOutput& output)
    {
        const ProgramInput input = values_.linked(output, SocketType::Vector);
        // A constant displacement lifts all of the surface alike and bends no normal.
        if (!input.is_constant()) {
            program_.displacement_ = input;
            program_.has_displacement_ = true;
        }
    }

private:
    void add_closures(const NodeOutput& output,
                      float constant_weight,
                      const std::vector<ProgramLeaf::Factor>& factors)
    {
        const NodeGraph::Node& node = graph_.node(output.node);
        if (is_on_the_way_[output.node]) {
            refuse_circle(graph_, output.node);
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
            add_leaf(node.made_closure(resources_), values_.inputs_of(node), constant_weight,
                     factors);
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
        const ProgramInput factor = values_.input_of(node, 0);
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
        NodeGraph shining;
        const NodeGraph::Node& emission = shining.node(shining.add("EMISSION"));
        std::vector<ProgramInput> inputs = values_.inputs_of(emission);
        inputs[0] = values_.linked(output, SocketType::Color);
        add_leaf(emission.made_closure(resources_), std::move(inputs), constant_weight, factors);
    }

    void add_leaf(std::shared_ptr<const ClosureNode> closure,
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
    ValueCompiler values_;
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

ShaderProgram ShaderProgram::of_value(const NodeGraph& graph,
                                      const NodeOutput& output,
                                      NodeResources& resources)
{
    ShaderProgram program;
    ValueCompiler values(graph, resources, program.steps_, program.value_count_);
    program.value_ = values.linked(output, SocketType::Color);
    return program;
}

}  // namespace eye_render
