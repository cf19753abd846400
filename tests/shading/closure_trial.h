// One closure shaded by itself, its inputs constant, on a surface whose normal is +Z.

#pragma once

#include "scattering.h"
#include "shading/nodes/node_tables.h"
#include "shading/nowhere.h"
#include "shading/program.h"

#include <stdexcept>
#include <string>
#include <string_view>

namespace eye_render::test {

// Of a node that names none.
class NothingToName final : public NodeResources {
public:
    [[nodiscard]] int uv_layer(const std::string& /*name*/) override { return 0; }
    [[nodiscard]] int attribute(const std::string& /*name*/) override { return 0; }
    void require_texture(int /*texture*/) override {}
    [[nodiscard]] WorkingSpace working_space() override { return WorkingSpace::Rec709; }
};

[[nodiscard]] inline const NodeType& closure_type_named(std::string_view name)
{
    for (const NodeType& type : closure_nodes()) {
        if (type.name == name) {
            return type;
        }
    }
    throw std::invalid_argument("there is no closure " + std::string(name));
}

[[nodiscard]] inline ShadingPoint seen_at(double angle_deg)
{
    return {.wo = direction_at(angle_deg), .ng = up, .ns = up};
}

class ClosureTrial {
public:
    // Throws what the node throws for an option.
    explicit ClosureTrial(std::string_view name, const NodeOptions& options = {})
        : type_(closure_type_named(name))
    {
        NothingToName resources;
        closure_ = type_.make_closure(options, resources);
        for (const InputSocket& socket : type_.inputs) {
            step_.inputs.push_back({.constant = socket.value, .implicit = socket.implicit});
        }
    }

    ClosureTrial& set(std::string_view input, const NodeValue& value)
    {
        step_.inputs[place_of(input)] = {.constant = value};
        return *this;
    }
    ClosureTrial& set(std::string_view input, float value) { return set(input, NodeValue(value)); }

    [[nodiscard]] ShadedPoint shade(const ShadingPoint& point, float weight = 1.0f) const
    {
        ShadedPoint shaded(point);
        visit(point, [&](const NodeInputs& in) { closure_->shade(in, weight, shaded); });
        return shaded;
    }
    [[nodiscard]] ShadedPoint shade(double angle_deg) const { return shade(seen_at(angle_deg)); }

    [[nodiscard]] Color3f emission(double angle_deg) const
    {
        Color3f found;
        visit(seen_at(angle_deg), [&](const NodeInputs& in) { found = closure_->emission(in); });
        return found;
    }

    [[nodiscard]] Color3f straight_transmittance() const
    {
        Color3f found;
        visit(seen_at(0.0),
              [&](const NodeInputs& in) { found = closure_->straight_transmittance(in); });
        return found;
    }

    [[nodiscard]] ClosureFacts facts() const
    {
        std::vector<std::optional<NodeValue>> constants;
        for (const ProgramInput& input : step_.inputs) {
            constants.push_back(input.is_constant() ? std::optional(input.constant)
                                                    : std::nullopt);
        }
        return closure_->facts(constants);
    }

private:
    template <typename Use>
    void visit(const ShadingPoint& point, Use&& use) const
    {
        const NowhereAttributes attributes;
        const PathState path;
        const Hit hit{.point = point, .attributes = attributes, .path = path};
        const std::vector<ProgramStep> no_steps;
        ProgramRun run(no_steps, 0, hit);
        use(NodeInputs(run, step_));
    }

    [[nodiscard]] std::size_t place_of(std::string_view identifier) const
    {
        for (std::size_t i = 0; i < type_.inputs.size(); ++i) {
            if (type_.inputs[i].identifier == identifier) {
                return i;
            }
        }
        throw std::invalid_argument(std::string(type_.name) + " has no socket " +
                                    std::string(identifier));
    }

    const NodeType& type_;
    std::shared_ptr<const ClosureNode> closure_;
    ProgramStep step_;
};

}  // namespace eye_render::test
