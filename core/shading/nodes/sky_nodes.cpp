// Sky Texture.

#include "shading/nodes/converter_nodes.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/vector_option.h"
#include "shading/sky/hosek_wilkie_sky.h"
#include "shading/sky/nishita_sky.h"
#include "shading/sky/preetham_sky.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

enum class SkyKind { Nishita, Preetham, HosekWilkie };

// Blender 5 calls Nishita's by another name.
[[nodiscard]] SkyKind sky_kind(const NodeOptions& options)
{
    return options.choice<SkyKind>("sky_type", {{"NISHITA", SkyKind::Nishita},
                                                {"SINGLE_SCATTERING", SkyKind::Nishita},
                                                {"PREETHAM", SkyKind::Preetham},
                                                {"HOSEK_WILKIE", SkyKind::HosekWilkie}});
}

[[nodiscard]] double ranged(const NodeOptions& options,
                            const char* name,
                            double otherwise,
                            double minimum,
                            double maximum,
                            const char* unit)
{
    const double value = options.number(name, otherwise);
    require_range(name, value, minimum, maximum, unit);
    return value;
}

[[nodiscard]] NishitaSettings nishita_settings(const NodeOptions& options)
{
    constexpr double any_angle_rad = 1e6;
    constexpr double densest = 10.0;
    const NishitaSettings usual;
    return {
        .has_disc = options.is_set("sun_disc", usual.has_disc),
        .sun_hides_sky =
            options.choice<bool>("sky_type", {{"NISHITA", true}, {"SINGLE_SCATTERING", false}}),
        .sun_size_rad = ranged(options, "sun_size", usual.sun_size_rad, 0.0, 1.5707964, "rad"),
        .sun_intensity = ranged(options, "sun_intensity", usual.sun_intensity, 0.0, 1000.0, ""),
        .sun_elevation_rad = ranged(options, "sun_elevation", usual.sun_elevation_rad,
                                    -any_angle_rad, any_angle_rad, "rad"),
        .sun_rotation_rad = ranged(options, "sun_rotation", usual.sun_rotation_rad, -any_angle_rad,
                                   any_angle_rad, "rad"),
        .altitude_m = ranged(options, "altitude", usual.altitude_m, 0.0, 1e5, "m"),
        .atmosphere = {.air = ranged(options, "air_density", 1.0, 0.0, densest, ""),
                       .dust = ranged(options, "dust_density", 1.0, 0.0, densest, ""),
                       .ozone = ranged(options, "ozone_density", 1.0, 0.0, densest, "")},
    };
}

class NishitaNode final : public ValueNode {
public:
    NishitaNode(const NodeOptions& options, WorkingSpace space)
        : sky_(nishita_settings(options), space)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = sky_.radiance(in.vector(0));
    }

private:
    NishitaSky sky_;
};

[[nodiscard]] V3f sun_direction(const NodeOptions& options)
{
    return vector_option(options, "sun_direction", V3f(0.0f, 0.0f, 1.0f));
}

[[nodiscard]] float turbidity(const NodeOptions& options)
{
    return static_cast<float>(ranged(options, "turbidity", 2.2, 1.0, 10.0, ""));
}

class PreethamNode final : public ValueNode {
public:
    PreethamNode(const NodeOptions& options, WorkingSpace space)
        : sky_(sun_direction(options), turbidity(options), space)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = sky_.radiance(in.vector(0));
    }

private:
    PreethamSky sky_;
};

class HosekWilkieNode final : public ValueNode {
public:
    HosekWilkieNode(const NodeOptions& options, WorkingSpace space)
        : sky_(sun_direction(options),
               turbidity(options),
               static_cast<float>(ranged(options, "ground_albedo", 0.3, 0.0, 1.0, "")),
               space)
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = sky_.radiance(in.vector(0));
    }

private:
    HosekWilkieSky sky_;
};

[[nodiscard]] std::unique_ptr<const ValueNode> make_sky(const NodeOptions& options,
                                                        NodeResources& resources)
{
    const WorkingSpace space = resources.working_space();
    switch (sky_kind(options)) {
    case SkyKind::Nishita: return std::make_unique<NishitaNode>(options, space);
    case SkyKind::HosekWilkie: return std::make_unique<HosekWilkieNode>(options, space);
    case SkyKind::Preetham: break;
    }
    return std::make_unique<PreethamNode>(options, space);
}

constexpr std::array sky_in{
    InputSocket{"Vector", Vector, NodeValue(0.0f), ImplicitInput::Generated}};
constexpr std::array color_out{OutputSocket{"Color", Color}};
constexpr std::array<std::string_view, 13> sky_options{
    "sky_type",    "sun_direction", "turbidity",     "ground_albedo", "sun_disc",
    "sun_size",    "sun_intensity", "sun_elevation", "sun_rotation",  "altitude",
    "air_density", "dust_density",  "ozone_density"};

}  // namespace

std::optional<SunDisc> sun_disc(const NodeOptions& options, WorkingSpace space)
{
    return sky_kind(options) == SkyKind::Nishita
               ? NishitaSun(nishita_settings(options), space).disc()
               : std::nullopt;
}

std::optional<SunDisc> sun_shown(const NodeGraph& graph,
                                 const NodeOutput& output,
                                 WorkingSpace space)
{
    for (const std::size_t number : graph.reached_from(output)) {
        const NodeGraph::Node& node = graph.node(number);
        if (node.type->name == "TEX_SKY" &&
            std::holds_alternative<std::monostate>(node.inputs.front())) {
            return sun_disc(node.options, space);
        }
    }
    return std::nullopt;
}

std::span<const NodeType> sky_nodes()
{
    static const std::array nodes{
        value_node("TEX_SKY", Reads::InputsAlone, sky_in, color_out, make_sky, sky_options)};
    return nodes;
}

}  // namespace eye_render
