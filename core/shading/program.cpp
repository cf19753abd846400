#include "shading/program.h"

#include "shading/bump.h"
#include "shading/nowhere.h"
#include "shading/object_space.h"
#include "shading/participating_medium.h"

#include <algorithm>
#include <functional>

namespace eye_render {

namespace {

[[nodiscard]] NodeValue implicit_value(ImplicitInput implicit, const Hit& hit)
{
    switch (implicit) {
    case ImplicitInput::Generated: return hit.attributes.generated();
    case ImplicitInput::Uv: {
        const V2f uv = hit.attributes.uv(HitAttributes::active_uv_layer);
        return {uv.x, uv.y, 0.0f};
    }
    case ImplicitInput::Normal: return hit.point.ns;
    case ImplicitInput::Position: return hit.attributes.position_world();
    case ImplicitInput::Incoming:
        return unit_or(normal_to_object(hit.attributes.object(), hit.point.wo), hit.point.wo);
    case ImplicitInput::StrandRandom:
        return NodeValue(hit.attributes.strand().value_or(StrandFacts{}).random);
    default: return NodeValue(0.0f);
    }
}

[[nodiscard]] Hit at(const ShadingPoint& point, const Hit& hit)
{
    return {.point = point, .attributes = hit.attributes, .path = hit.path, .probe = hit.probe};
}

}  // namespace

NodeValue NodeInputs::computed(const ProgramInput& source) const { return run_.read(source); }

float NodeInputs::number_at(std::size_t input, const HitAttributes& attributes) const
{
    return run_.read_at(inputs_[input], attributes).x;
}

const Hit& NodeInputs::hit() const { return run_.hit(); }

ProgramRun::ProgramRun(const std::vector<ProgramStep>& steps, int value_count, const Hit& hit)
    : steps_(steps), hit_(hit), value_count_(value_count)
{
    if (static_cast<std::size_t>(value_count) > usual_size) {
        more_values_.resize(static_cast<std::size_t>(value_count));
        values_ = more_values_.data();
    }
    if (steps.size() > usual_size) {
        more_states_.resize(steps.size());
        states_ = more_states_.data();
    }
    std::fill_n(states_, steps.size(), StepState::Open);
}

NodeValue ProgramRun::read(const ProgramInput& input)
{
    if (input.step != ProgramInput::none) {
        if (states_[input.step] != StepState::Done) {
            evaluate(input.step);
        }
        return converted(values_[input.value], input.conversion, input.constant);
    }
    return input.implicit == ImplicitInput::None ? input.constant
                                                 : implicit_value(input.implicit, hit_);
}

NodeValue ProgramRun::read_at(const ProgramInput& input, const HitAttributes& attributes) const
{
    ProgramRun elsewhere(steps_, value_count_,
                         {.point = hit_.point, .attributes = attributes, .path = hit_.path});
    return elsewhere.read(input);
}

float ProgramRun::weight(const ProgramLeaf& leaf)
{
    float weight = leaf.constant_weight;
    for (const ProgramLeaf::Factor& factor : leaf.factors) {
        const float value = read(factor.input).x;
        // NaN counts as 0.
        const float share = value > 0.0f ? std::min(value, 1.0f) : 0.0f;
        weight *= factor.is_rest ? 1.0f - share : share;
    }
    return weight;
}

void ProgramRun::evaluate(int number)
{
    const ProgramStep& step = steps_[static_cast<std::size_t>(number)];
    states_[number] = StepState::Done;
    std::array<NodeValue, ProgramStep::most_outputs> outputs;
    step.node->evaluate(NodeInputs(*this, step), {outputs.data(), step.output_count});
    for (const ProgramStep::Wanted& wanted : step.wanted) {
        values_[wanted.value] = outputs[wanted.output];
    }
}

ShadingPoint ShaderProgram::displaced(const Hit& hit) const
{
    ShadingPoint point = hit.point;
    if (!has_displacement_) {
        return point;
    }
    ProgramRun here(steps_, value_count_, hit);
    const auto offsets = bump_offsets(hit.point, hit.attributes.position_world());
    const float height = here.read(displacement_).dot(hit.point.ns);
    V2f rise(0.0f);
    for (int i = 0; i < 2; ++i) {
        const auto look = [&](const HitAttributes& there) {
            rise[i] = here.read_at(displacement_, there).dot(hit.point.ns) - height;
        };
        // By reference: what it captures is more than std::function holds without the heap.
        hit.attributes.moved(offsets[static_cast<std::size_t>(i)], std::ref(look));
    }
    point.ns = bumped_normal(hit.point.ns, offsets, rise);
    return point;
}

ShadedPoint ShaderProgram::shade(const Hit& hit) const
{
    const ShadingPoint point = displaced(hit);
    ProgramRun run(steps_, value_count_, at(point, hit));
    ShadedPoint shaded(point);
    for (const ProgramLeaf& leaf : leaves_) {
        const float weight = run.weight(leaf);
        if (weight > 0.0f) {
            leaf.closure->shade(NodeInputs(run, leaf.step), weight, shaded);
        }
    }
    return shaded;
}

Color3f ShaderProgram::straight_transmittance(const Hit& hit) const
{
    const ShadingPoint point = displaced(hit);
    ProgramRun run(steps_, value_count_, at(point, hit));
    Color3f sum(0.0f);
    for (const ProgramLeaf& leaf : leaves_) {
        if (!leaf.facts.may_be_transparent) {
            continue;
        }
        const float weight = run.weight(leaf);
        if (weight > 0.0f) {
            sum += leaf.closure->straight_transmittance(NodeInputs(run, leaf.step)) * weight;
        }
    }
    return sum;
}

Color3f ShaderProgram::emission(const Hit& hit) const
{
    const ShadingPoint point = displaced(hit);
    ProgramRun run(steps_, value_count_, at(point, hit));
    Color3f sum(0.0f);
    for (const ProgramLeaf& leaf : leaves_) {
        if (!leaf.facts.may_emit) {
            continue;
        }
        const float weight = run.weight(leaf);
        if (weight > 0.0f) {
            sum += leaf.closure->emission(NodeInputs(run, leaf.step)) * weight;
        }
    }
    return sum;
}

NodeValue ShaderProgram::value(const Hit& hit) const
{
    ProgramRun run(steps_, value_count_, hit);
    return run.read(value_);
}

bool ShaderProgram::varies_in_space() const
{
    return std::ranges::any_of(steps_, &ProgramStep::varies_in_space);
}

ParticipatingMedium ShaderProgram::medium(const Hit& hit) const
{
    ProgramRun run(steps_, value_count_, hit);
    ParticipatingMedium medium;
    for (const ProgramLeaf& leaf : leaves_) {
        const float weight = run.weight(leaf);
        if (weight > 0.0f) {
            leaf.closure->fill(NodeInputs(run, leaf.step), weight, medium);
        }
    }
    return medium;
}

std::optional<Color3f> ShaderProgram::constant_emission() const
{
    Color3f sum(0.0f);
    for (const ProgramLeaf& leaf : leaves_) {
        if (!leaf.facts.may_emit) {
            continue;
        }
        if (!leaf.factors.empty() ||
            !std::ranges::all_of(leaf.step.inputs, &ProgramInput::is_constant)) {
            return std::nullopt;
        }
        const Nowhere nowhere;
        ProgramRun run(steps_, value_count_, nowhere.hit());
        sum += leaf.closure->emission(NodeInputs(run, leaf.step)) * leaf.constant_weight;
    }
    return sum;
}

}  // namespace eye_render
