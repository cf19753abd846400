// Gabor Texture.

#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/gabor.h"

#include <array>
#include <numbers>

namespace eye_render {

namespace {

class GaborNode final : public ValueNode {
public:
    enum Input : std::size_t { Vector, Scale, Frequency, Anisotropy, Direction2d, Direction3d };
    enum Output : std::size_t { Value, Phase, Intensity };

    explicit GaborNode(const NodeOptions& options)
        : is_in_space_(options.choice<bool>("gabor_type", {{"2D", false}, {"3D", true}}))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const GaborAnswer answer = look_up(in);
        out[Value] = NodeValue(answer.value);
        out[Phase] = NodeValue(answer.phase);
        out[Intensity] = NodeValue(answer.intensity);
    }

private:
    [[nodiscard]] GaborAnswer look_up(const NodeInputs& in) const
    {
        const Gabor gabor{.frequency = in.number(Frequency), .anisotropy = in.number(Anisotropy)};
        const V3f p = in.vector(Vector) * in.number(Scale);
        if (is_in_space_) {
            return gabor_texture(Point<3>{{p.x, p.y, p.z}}, gabor, in.vector(Direction3d));
        }
        return gabor_texture(Point<2>{{p.x, p.y}}, gabor, in.number(Direction2d));
    }

    bool is_in_space_;
};

}  // namespace

NodeType gabor_texture_node()
{
    constexpr float eighth_turn_rad = std::numbers::pi_v<float> / 4.0f;
    constexpr float root2 = std::numbers::sqrt2_v<float>;
    static constexpr std::array inputs{texture_vector,
                                       texture_scale,
                                       number_input("Frequency", 2.0f),
                                       number_input("Anisotropy", 1.0f),
                                       number_input("Orientation 2D", eighth_turn_rad),
                                       vector_input("Orientation 3D", {root2, root2, 0.0f})};
    static constexpr std::array outputs{OutputSocket{"Value"}, OutputSocket{"Phase"},
                                        OutputSocket{"Intensity"}};
    static constexpr std::array<std::string_view, 1> options{"gabor_type"};
    return value_node("TEX_GABOR", Reads::InputsAlone, inputs, outputs,
                      make_from_options<GaborNode>, options);
}

}  // namespace eye_render
