// A tree of shader nodes compiled for evaluation: what a material, the world or a lamp is made of.
//
// Mix and Add Shader are gone: each closure that can have any weight is a leaf with the product of
// the mix factors on its way. Values are pulled by the leaves, so a leaf of zero weight costs its
// factors alone.

#pragma once

#include "shading/node.h"
#include "shading/node_graph.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eye_render {

// `weights` are those of the channels in luminance.
[[nodiscard]] inline NodeValue converted(const NodeValue& value,
                                         Conversion conversion,
                                         const V3f& weights)
{
    switch (conversion) {
    case Conversion::Splat: return NodeValue(value.x);
    case Conversion::Mean: return NodeValue((value.x + value.y + value.z) / 3.0f);
    case Conversion::Luminance: return NodeValue(weights.dot(value));
    default: return value;
    }
}

struct ProgramStep {
    // An output that somebody reads.
    struct Wanted {
        std::size_t output;
        int value;  // its place among the values of a run
    };
    // Of a node.
    static constexpr std::size_t most_outputs = 32;

    std::vector<ProgramInput> inputs;
    std::shared_ptr<const ValueNode> node{};  // none for a closure
    std::size_t output_count = 0;
    std::uint32_t wanted_outputs = 0;  // one bit each
    std::vector<Wanted> wanted{};      // the same, with their places
    bool varies_in_space = false;      // reads more than what is the same all over an object
};

inline NodeInputs::NodeInputs(ProgramRun& run, const ProgramStep& step)
    : run_(run), inputs_(step.inputs.data()), wanted_outputs_(step.wanted_outputs)
{
}

struct ProgramLeaf {
    // A share of a mix: the factor, or what it leaves.
    struct Factor {
        ProgramInput input;
        bool is_rest = false;
    };
    ProgramStep step;
    std::shared_ptr<const ClosureNode> closure;
    float constant_weight = 1.0f;
    std::vector<Factor> factors;
    ClosureFacts facts;
};

class ShaderProgram {
public:
    // Scatters nothing and emits nothing.
    ShaderProgram() = default;

    // Throws std::invalid_argument for a graph that runs in a circle, for a texture that the scene
    // does not have, or for more lobes than a mixture holds.
    ShaderProgram(const NodeGraph& graph,
                  const std::optional<NodeOutput>& surface,
                  const std::optional<NodeOutput>& displacement,
                  NodeResources& resources);

    // One that only has a value, of no kind of socket in particular.
    [[nodiscard]] static ShaderProgram of_value(const NodeGraph& graph,
                                                const NodeOutput& output,
                                                NodeResources& resources);

    // All that scatters and shines at the hit.
    [[nodiscard]] ShadedPoint shade(const Hit& hit) const;
    // The part of light that passes straight through, without building the mixture.
    [[nodiscard]] Color3f straight_transmittance(const Hit& hit) const;
    // Radiance towards the viewer, without building the mixture.
    [[nodiscard]] Color3f emission(const Hit& hit) const;

    // Of a program that has one.
    [[nodiscard]] NodeValue value(const Hit& hit) const;
    // What the closures make of the inside of an object, there.
    [[nodiscard]] ParticipatingMedium medium(const Hit& hit) const;

    // True if light may pass straight through some point of the surface.
    [[nodiscard]] bool may_be_transparent() const { return may_be_transparent_; }
    [[nodiscard]] bool may_emit() const { return may_emit_; }
    // False if light comes out from below the surface around the smooth normal everywhere.
    [[nodiscard]] bool bends_subsurface() const { return bends_subsurface_ || has_displacement_; }
    // What `emission` gives everywhere, if it is one thing.
    [[nodiscard]] std::optional<Color3f> constant_emission() const;

    // False if everything that is read is the same all over an object.
    [[nodiscard]] bool varies_in_space() const;

    [[nodiscard]] std::size_t step_count() const { return steps_.size(); }
    [[nodiscard]] std::size_t leaf_count() const { return leaves_.size(); }

private:
    friend class ProgramCompiler;  // fills it in

    // The point with its normal bent by the displacement, if there is one.
    [[nodiscard]] ShadingPoint displaced(const Hit& hit) const;

    std::vector<ProgramStep> steps_;
    std::vector<ProgramLeaf> leaves_;
    ProgramInput displacement_;
    bool has_displacement_ = false;
    ProgramInput value_;
    int value_count_ = 0;
    bool may_be_transparent_ = false;
    bool may_emit_ = false;
    bool bends_subsurface_ = false;
};

// One evaluation of a program: remembers what was computed. On the stack; as large as a usual
// program needs, and larger on the heap.
class ProgramRun {
public:
    ProgramRun(const std::vector<ProgramStep>& steps, int value_count, const Hit& hit);
    ProgramRun(const ProgramRun&) = delete;
    ProgramRun& operator=(const ProgramRun&) = delete;

    [[nodiscard]] NodeValue read(const ProgramInput& input);
    // The same of another place of the surface.
    [[nodiscard]] NodeValue read_at(const ProgramInput& input,
                                    const HitAttributes& attributes) const;
    [[nodiscard]] float weight(const ProgramLeaf& leaf);
    [[nodiscard]] const Hit& hit() const { return hit_; }

private:
    // Wanted values, and steps: a group of nodes may bring a hundred. What is not used is not
    // touched.
    static constexpr std::size_t usual_size = 512;

    enum class StepState : std::uint8_t { Open, Done };

    void evaluate(int number);

    const std::vector<ProgramStep>& steps_;
    Hit hit_;
    int value_count_;
    std::array<StepState, usual_size> usual_states_;
    std::array<NodeValue, usual_size> usual_values_;  // not cleared: it would cost more
    std::vector<NodeValue> more_values_;
    std::vector<StepState> more_states_;
    NodeValue* values_ = usual_values_.data();
    StepState* states_ = usual_states_.data();  // one a step
};

}  // namespace eye_render
