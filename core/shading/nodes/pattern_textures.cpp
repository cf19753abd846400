// Textures that repeat: Wave, Magic, Brick and Checker. And Gradient.

#include "base/error.h"
#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/brick.h"
#include "shading/procedural/checker.h"
#include "shading/procedural/gradient.h"
#include "shading/procedural/magic.h"
#include "shading/procedural/safe_float.h"
#include "shading/procedural/wave.h"

namespace eye_render {

namespace {

// Of Checker and Brick.
constexpr InputSocket color1{"Color1", SocketType::Color, NodeValue(0.8f)};
constexpr InputSocket color2{"Color2", SocketType::Color, NodeValue(0.2f)};
constexpr InputSocket texture_scale{"Scale", SocketType::Number, NodeValue(5.0f)};

[[nodiscard]] float number_in_range(const NodeOptions& options,
                                    const char* name,
                                    double otherwise,
                                    double lowest,
                                    double highest)
{
    const double value = options.number(name, otherwise);
    require_range(name, value, lowest, highest, "");
    return static_cast<float>(value);
}

[[nodiscard]] int integer_in_range(const NodeOptions& options,
                                   const char* name,
                                   double otherwise,
                                   double lowest,
                                   double highest)
{
    return static_cast<int>(number_in_range(options, name, otherwise, lowest, highest));
}

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

class BrickNode final : public ValueNode {
public:
    enum Input : std::size_t {
        Vector,
        Color1,
        Color2,
        Mortar,
        Scale,
        MortarSize,
        MortarSmooth,
        Bias,
        BrickWidth,
        RowHeight
    };
    enum Output : std::size_t { Color, Fac };

    explicit BrickNode(const NodeOptions& options)
        : layout_{
              .offset = number_in_range(options, "offset", 0.5, 0.0, 1.0),
              .offset_frequency = integer_in_range(options, "offset_frequency", 2.0, 1.0, 99.0),
              .squash = number_in_range(options, "squash", 1.0, 0.0, 99.0),
              .squash_frequency = integer_in_range(options, "squash_frequency", 2.0, 1.0, 99.0)}
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        Brick brick = layout_;
        brick.mortar_size = in.number(MortarSize);
        brick.mortar_smooth = in.number(MortarSmooth);
        brick.bias = in.number(Bias);
        brick.brick_width = in.number(BrickWidth);
        brick.row_height = in.number(RowHeight);
        const auto [tint, mortar] = brick_texture(in.vector(Vector) * in.number(Scale), brick);
        out[Fac] = NodeValue(mortar);
        if (in.wants(Color)) {
            const V3f stone = blend(in.vector(Color1), in.vector(Color2), tint);
            out[Color] = blend(stone, in.vector(Mortar), mortar);
        }
    }

private:
    Brick layout_;
};

class CheckerNode final : public ValueNode {
public:
    enum Input : std::size_t { Vector, Color1, Color2, Scale };
    enum Output : std::size_t { Color, Fac };

    explicit CheckerNode(const NodeOptions& /*options*/) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const bool is_set = checker_texture(in.vector(Vector) * in.number(Scale));
        out[Fac] = NodeValue(is_set ? 1.0f : 0.0f);
        if (in.wants(Color)) {
            out[Color] = in.vector(is_set ? Color1 : Color2);
        }
    }
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
    static constexpr InputSocket inputs[] = {
        texture_vector,
        texture_scale,
        {"Distortion"},
        {"Detail", SocketType::Number, NodeValue(2.0f)},
        {"Detail Scale", SocketType::Number, NodeValue(1.0f)},
        {"Detail Roughness", SocketType::Number, NodeValue(0.5f)},
        {"Phase Offset"}};
    static constexpr std::string_view options[] = {"wave_type", "bands_direction",
                                                   "rings_direction", "wave_profile"};
    return {.name = "TEX_WAVE",
            .inputs = inputs,
            .outputs = color_and_fac,
            .options = options,
            .make_value = make_texture<WaveNode>};
}

NodeType magic_texture_node()
{
    static constexpr InputSocket inputs[] = {
        texture_vector, texture_scale, {"Distortion", SocketType::Number, NodeValue(1.0f)}};
    static constexpr std::string_view options[] = {"turbulence_depth"};
    return {.name = "TEX_MAGIC",
            .inputs = inputs,
            .outputs = color_and_fac,
            .options = options,
            .make_value = make_texture<MagicNode>};
}

NodeType brick_texture_node()
{
    static constexpr InputSocket inputs[] = {
        texture_vector,
        color1,
        color2,
        {"Mortar", SocketType::Color},
        texture_scale,
        {"Mortar Size", SocketType::Number, NodeValue(0.02f)},
        {"Mortar Smooth", SocketType::Number, NodeValue(0.1f)},
        {"Bias"},
        {"Brick Width", SocketType::Number, NodeValue(0.5f)},
        {"Row Height", SocketType::Number, NodeValue(0.25f)}};
    static constexpr std::string_view options[] = {"offset", "offset_frequency", "squash",
                                                   "squash_frequency"};
    return {.name = "TEX_BRICK",
            .inputs = inputs,
            .outputs = color_and_fac,
            .options = options,
            .make_value = make_texture<BrickNode>};
}

NodeType checker_texture_node()
{
    static constexpr InputSocket inputs[] = {texture_vector, color1, color2, texture_scale};
    return {.name = "TEX_CHECKER",
            .inputs = inputs,
            .outputs = color_and_fac,
            .options = {},
            .make_value = make_texture<CheckerNode>};
}

NodeType gradient_texture_node()
{
    static constexpr InputSocket inputs[] = {texture_vector};
    static constexpr std::string_view options[] = {"gradient_type"};
    return {.name = "TEX_GRADIENT",
            .inputs = inputs,
            .outputs = color_and_fac,
            .options = options,
            .make_value = make_texture<GradientNode>};
}

}  // namespace eye_render
