// Closures of volumes, their coefficients as Cycles derives them from colour and density.

#include "shading/functions/spectral_colors.h"
#include "shading/input_range.h"
#include "shading/nodes/closure_nodes.h"
#include "shading/nodes/phase_inputs.h"
#include "shading/participating_medium.h"

#include <cmath>
#include <numbers>

namespace eye_render {

namespace {

// Has no surface: neither scatters nor shines where one is asked for.
class VolumeNode : public ClosureNode {
public:
    [[nodiscard]] ClosureFacts facts(ConstantInputs /*constants*/) const override { return {}; }

    void shade(const NodeInputs& /*in*/, float /*weight*/, ShadedPoint& /*shaded*/) const override
    {
    }
};

// What `color` leaves of white.
[[nodiscard]] Color3f complement(const Color3f& color)
{
    return positive_range(Color3f(1.0f) - color);
}

class VolumeAbsorptionNode : public VolumeNode {
public:
    enum Input : std::size_t { Color, Density };

    explicit VolumeAbsorptionNode(const NodeOptions& /*options*/) {}

    void fill(const NodeInputs& in, float weight, ParticipatingMedium& medium) const override
    {
        medium.extinction +=
            complement(in.color(Color)) * positive_range(in.number(Density)) * weight;
    }
};

class VolumeScatterNode : public VolumeNode {
public:
    enum Input : std::size_t { Color, Density, Ior, Backscatter, Anisotropy, Alpha, Diameter };

    explicit VolumeScatterNode(const NodeOptions& options) : phase_(phase_kind(options)) {}

    void fill(const NodeInputs& in, float weight, ParticipatingMedium& medium) const override
    {
        add_scattering(
            in, phase_, {Ior, Backscatter, Anisotropy, Alpha, Diameter},
            positive_range(in.color(Color)) * positive_range(in.number(Density)) * weight, medium);
    }

private:
    PhaseKind phase_;
};

class VolumeCoefficientsNode : public VolumeNode {
public:
    enum Input : std::size_t {
        Absorption,
        Scatter,
        Ior,
        Backscatter,
        Anisotropy,
        Alpha,
        Diameter,
        Emission
    };

    explicit VolumeCoefficientsNode(const NodeOptions& options) : phase_(phase_kind(options)) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs constants) const override
    {
        return {.may_emit = !is_constantly_zero(constants, Emission)};
    }

    void fill(const NodeInputs& in, float weight, ParticipatingMedium& medium) const override
    {
        add_scattering(in, phase_, {Ior, Backscatter, Anisotropy, Alpha, Diameter},
                       positive_range(in.color(Scatter)) * weight, medium);
        medium.extinction += positive_range(in.color(Absorption)) * weight;
        medium.emission += positive_range(in.color(Emission)) * weight;
    }

private:
    PhaseKind phase_;
};

class PrincipledVolumeNode : public VolumeNode {
public:
    enum Input : std::size_t {
        Color,
        Density,
        Anisotropy,
        AbsorptionColor,
        EmissionStrength,
        EmissionColor,
        BlackbodyIntensity,
        BlackbodyTint,
        Temperature,
    };

    PrincipledVolumeNode(const NodeOptions& /*options*/, WorkingSpace space) : space_(space) {}

    [[nodiscard]] ClosureFacts facts(ConstantInputs constants) const override
    {
        return {.may_emit = !is_constantly_zero(constants, EmissionStrength) ||
                            !is_constantly_zero(constants, BlackbodyIntensity)};
    }

    void fill(const NodeInputs& in, float weight, ParticipatingMedium& medium) const override
    {
        const float density = positive_range(in.number(Density)) * weight;
        if (density > 0.0f) {
            const Color3f color = positive_range(in.color(Color));
            const Color3f tint = positive_range(in.color(AbsorptionColor));
            const Color3f root(std::sqrt(tint.x), std::sqrt(tint.y), std::sqrt(tint.z));
            medium.scatter({color * density, {.g = anisotropy_range(in.number(Anisotropy))}});
            medium.extinction += (color + complement(color) * complement(root)) * density;
        }
        const float strength = positive_range(in.number(EmissionStrength));
        if (strength > 0.0f) {
            medium.emission += positive_range(in.color(EmissionColor)) * (strength * weight);
        }
        const float heat = positive_range(in.number(BlackbodyIntensity));
        if (heat > 0.0f) {
            medium.emission += glow(in.number(Temperature), heat) *
                               positive_range(in.color(BlackbodyTint)) * weight;
        }
    }

private:
    // Radiance of a black body by Stefan and Boltzmann's law, in Cycles' unit of 1 MW/m^2; `heat`
    // leads there from a radiance of one such unit.
    [[nodiscard]] Color3f glow(float temperature_k, float heat) const
    {
        constexpr float stefan_boltzmann = 5.670373e-8f;
        constexpr float unit_w = 1e6f;
        const float t2 = positive_range(temperature_k) * positive_range(temperature_k);
        const float power = 1.0f + (t2 * t2 - 1.0f) * heat;
        return rgb_of_blackbody(temperature_k, space_) *
               (stefan_boltzmann / unit_w * std::numbers::inv_pi_v<float> * power);
    }

    WorkingSpace space_;
};

constexpr auto volume_output = std::to_array<OutputSocket>({{"Volume", SocketType::Shader}});
constexpr auto phase_options = std::to_array<std::string_view>({"phase"});

}  // namespace

NodeType volume_absorption_node()
{
    static constexpr auto inputs =
        std::to_array<InputSocket>({color_input("Color", 0.8f), number_input("Density", 1.0f)});
    return closure_type<VolumeAbsorptionNode>("VOLUME_ABSORPTION", inputs, volume_output);
}

NodeType volume_scatter_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {color_input("Color", 0.8f), number_input("Density", 1.0f), number_input("IOR", 1.33f),
         number_input("Backscatter", 0.1f), number_input("Anisotropy", 0.0f),
         number_input("Alpha", 0.5f), number_input("Diameter", 20.0f)});
    return closure_type<VolumeScatterNode>("VOLUME_SCATTER", inputs, volume_output, phase_options);
}

NodeType volume_coefficients_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {{"Absorption Coefficients", SocketType::Vector, NodeValue(1.0f)},
         {"Scatter Coefficients", SocketType::Vector, NodeValue(1.0f)},
         number_input("IOR", 1.33f),
         number_input("Backscatter", 0.1f),
         number_input("Anisotropy", 0.0f),
         number_input("Alpha", 0.5f),
         number_input("Diameter", 20.0f),
         {"Emission Coefficients", SocketType::Vector, NodeValue(0.0f)}});
    return closure_type<VolumeCoefficientsNode>("VOLUME_COEFFICIENTS", inputs, volume_output,
                                                phase_options);
}

NodeType principled_volume_node()
{
    static constexpr auto inputs = std::to_array<InputSocket>(
        {color_input("Color", 0.5f), number_input("Density", 1.0f),
         number_input("Anisotropy", 0.0f), color_input("Absorption Color", 0.0f),
         number_input("Emission Strength", 0.0f), color_input("Emission Color", 1.0f),
         number_input("Blackbody Intensity", 0.0f), color_input("Blackbody Tint", 1.0f),
         number_input("Temperature", 1000.0f)});
    return closure_type<PrincipledVolumeNode>("PRINCIPLED_VOLUME", inputs, volume_output);
}

}  // namespace eye_render
