// Textures made of tiles: Brick and Checker.

#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/brick.h"
#include "shading/procedural/checker.h"
#include "shading/procedural/safe_float.h"

#include <array>

namespace eye_render {

namespace {

constexpr InputSocket color1{"Color1", SocketType::Color, NodeValue(0.8f)};
constexpr InputSocket color2{"Color2", SocketType::Color, NodeValue(0.2f)};

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

}  // namespace

NodeType brick_texture_node()
{
    static constexpr std::array inputs{texture_vector,
                                       color1,
                                       color2,
                                       color_input("Mortar", 0.0f),
                                       texture_scale,
                                       number_input("Mortar Size", 0.02f),
                                       number_input("Mortar Smooth", 0.1f),
                                       number_input("Bias"),
                                       number_input("Brick Width", 0.5f),
                                       number_input("Row Height", 0.25f)};
    static constexpr std::array<std::string_view, 4> options{"offset", "offset_frequency",
                                                             "squash", "squash_frequency"};
    return value_node("TEX_BRICK", Reads::InputsAlone, inputs, color_and_fac,
                      make_from_options<BrickNode>, options);
}

NodeType checker_texture_node()
{
    static constexpr std::array inputs{texture_vector, color1, color2, texture_scale};
    return value_node("TEX_CHECKER", Reads::InputsAlone, inputs, color_and_fac,
                      make_from_options<CheckerNode>);
}

}  // namespace eye_render
