// Textures that change steadily: Wave, Magic and Gradient.

#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/gradient.h"
#include "shading/procedural/magic.h"
#include "shading/procedural/wave.h"

#include <array>

namespace eye_render {

namespace {

class WaveNode final : public ValueNode {
public:
    enum Input : std::size_t {
        Vector,
        Scale,
        Distortion,
        Detail,
        DetailScale,
        DetailRoughness,
        PhaseOffset
    };
    enum Output : std::size_t { Color, Fac };

    explicit WaveNode(const NodeOptions& options)
        : type_(
              options.choice<WaveType>("wave_type",
                                       {{"BANDS", WaveType::Bands}, {"RINGS", WaveType::Rings}})),
          direction_(type_ == WaveType::Bands
                         ? direction(options, "bands_direction", "DIAGONAL")
                         : direction(options, "rings_direction", "SPHERICAL")),
          profile_(options.choice<WaveProfile>("wave_profile",
                                               {{"SIN", WaveProfile::Sine},
                                                {"SAW", WaveProfile::Saw},
                                                {"TRI", WaveProfile::Triangle}}))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float value = wave_texture(in.vector(Vector) * in.number(Scale),
                                         {.type = type_,
                                          .direction = direction_,
                                          .profile = profile_,
                                          .distortion = in.number(Distortion),
                                          .detail = in.number(Detail),
                                          .detail_scale = in.number(DetailScale),
                                          .detail_roughness = in.number(DetailRoughness),
                                          .phase_offset = in.number(PhaseOffset)});
        out[Color] = out[Fac] = NodeValue(value);
    }

private:
    [[nodiscard]] static WaveDirection direction(const NodeOptions& options,
                                                 const char* name,
                                                 const char* all)
    {
        return options.choice<WaveDirection>(name, {{"X", WaveDirection::X},
                                                    {"Y", WaveDirection::Y},
                                                    {"Z", WaveDirection::Z},
                                                    {all, WaveDirection::All}});
    }

    WaveType type_;
    WaveDirection direction_;
    WaveProfile profile_;
};

class MagicNode final : public ValueNode {
public:
    enum Input : std::size_t { Vector, Scale, Distortion };
    enum Output : std::size_t { Color, Fac };

    explicit MagicNode(const NodeOptions& options)
        : depth_(integer_in_range(options, "turbulence_depth", 2.0, 0.0, 10.0))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Color3f color =
            magic_texture(in.vector(Vector), in.number(Scale), depth_, in.number(Distortion));
        out[Color] = color;
        out[Fac] = NodeValue((color.x + color.y + color.z) / 3.0f);
    }

private:
    int depth_;
};

class GradientNode final : public ValueNode {
public:
    enum Input : std::size_t { Vector };
    enum Output : std::size_t { Color, Fac };

    explicit GradientNode(const NodeOptions& options)
        : type_(options.choice<GradientType>("gradient_type",
                                             {{"LINEAR", GradientType::Linear},
                                              {"QUADRATIC", GradientType::Quadratic},
                                              {"EASING", GradientType::Easing},
                                              {"DIAGONAL", GradientType::Diagonal},
                                              {"SPHERICAL", GradientType::Spherical},
                                              {"QUADRATIC_SPHERE", GradientType::QuadraticSphere},
                                              {"RADIAL", GradientType::Radial}}))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[Color] = out[Fac] = NodeValue(gradient_texture(in.vector(Vector), type_));
    }

private:
    GradientType type_;
};

}  // namespace

NodeType wave_texture_node()
{
    static constexpr std::array inputs{texture_vector,
                                       texture_scale,
                                       number_input("Distortion"),
                                       number_input("Detail", 2.0f),
                                       number_input("Detail Scale", 1.0f),
                                       number_input("Detail Roughness", 0.5f),
                                       number_input("Phase Offset")};
    static constexpr std::array<std::string_view, 4> options{"wave_type", "bands_direction",
                                                             "rings_direction", "wave_profile"};
    return value_node("TEX_WAVE", Reads::InputsAlone, inputs, color_and_fac,
                      make_from_options<WaveNode>, options);
}

NodeType magic_texture_node()
{
    static constexpr std::array inputs{texture_vector, texture_scale,
                                       number_input("Distortion", 1.0f)};
    static constexpr std::array<std::string_view, 1> options{"turbulence_depth"};
    return value_node("TEX_MAGIC", Reads::InputsAlone, inputs, color_and_fac,
                      make_from_options<MagicNode>, options);
}

NodeType gradient_texture_node()
{
    static constexpr std::array inputs{texture_vector};
    static constexpr std::array<std::string_view, 1> options{"gradient_type"};
    return value_node("TEX_GRADIENT", Reads::InputsAlone, inputs, color_and_fac,
                      make_from_options<GradientNode>, options);
}

}  // namespace eye_render
