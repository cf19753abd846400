// Noise Texture and White Noise Texture.

#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/hash.h"
#include "shading/procedural/noise.h"

#include <array>

namespace eye_render {

namespace {

class NoiseNode final : public ValueNode {
public:
    enum Input : std::size_t {
        Vector,
        W,
        Scale,
        Detail,
        Roughness,
        Lacunarity,
        Offset,
        Gain,
        Distortion
    };
    enum Output : std::size_t { Fac, Color };

    explicit NoiseNode(const NodeOptions& options)
        : dimensions_(dimensions_of(options, "noise_dimensions")),
          type_(options.choice<FractalType>(
              "noise_type",
              {{"FBM", FractalType::Fbm},
               {"MULTIFRACTAL", FractalType::Multifractal},
               {"HYBRID_MULTIFRACTAL", FractalType::HybridMultifractal},
               {"RIDGED_MULTIFRACTAL", FractalType::RidgedMultifractal},
               {"HETERO_TERRAIN", FractalType::HeteroTerrain}})),
          is_normalized_(options.is_set("normalize", true))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Noise noise{.fractal = {.type = type_,
                                      .is_normalized = is_normalized_,
                                      .detail = in.number(Detail),
                                      .roughness = in.number(Roughness),
                                      .lacunarity = in.number(Lacunarity),
                                      .offset = in.number(Offset),
                                      .gain = in.number(Gain)},
                          .distortion = in.number(Distortion)};
        const float scale = in.number(Scale);
        if (in.wants(Color)) {
            out[Color] = in_dimensions(dimensions_, in, Vector, W, [&](const auto& p) {
                return noise_color(p * scale, noise);
            });
            out[Fac] = NodeValue(out[Color].x);
        } else {
            out[Fac] = NodeValue(in_dimensions(dimensions_, in, Vector, W, [&](const auto& p) {
                return noise_value(p * scale, noise);
            }));
        }
    }

private:
    int dimensions_;
    FractalType type_;
    bool is_normalized_;
};

class WhiteNoiseNode final : public ValueNode {
public:
    enum Input : std::size_t { Vector, W };
    enum Output : std::size_t { Value, Color };

    explicit WhiteNoiseNode(const NodeOptions& options)
        : dimensions_(dimensions_of(options, "noise_dimensions"))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[Color] = in_dimensions(dimensions_, in, Vector, W,
                                   [](const auto& p) { return random_color(p); });
        out[Value] = NodeValue(out[Color].x);
    }

private:
    int dimensions_;
};

}  // namespace

NodeType noise_texture_node()
{
    static constexpr std::array inputs{texture_vector,
                                       number_input("W"),
                                       number_input("Scale", 5.0f),
                                       number_input("Detail", 2.0f),
                                       number_input("Roughness", 0.5f),
                                       number_input("Lacunarity", 2.0f),
                                       number_input("Offset"),
                                       number_input("Gain", 1.0f),
                                       number_input("Distortion")};
    static constexpr std::array outputs{OutputSocket{"Fac"},
                                        OutputSocket{"Color", SocketType::Color}};
    static constexpr std::array<std::string_view, 3> options{"noise_dimensions", "noise_type",
                                                             "normalize"};
    return value_node("TEX_NOISE", Reads::InputsAlone, inputs, outputs,
                      make_from_options<NoiseNode>, options);
}

NodeType white_noise_node()
{
    // Alone among textures it is one thing everywhere unless told otherwise.
    static constexpr std::array inputs{InputSocket{"Vector", SocketType::Vector},
                                       number_input("W")};
    static constexpr std::array outputs{OutputSocket{"Value"},
                                        OutputSocket{"Color", SocketType::Color}};
    static constexpr std::array<std::string_view, 1> options{"noise_dimensions"};
    return value_node("TEX_WHITE_NOISE", Reads::InputsAlone, inputs, outputs,
                      make_from_options<WhiteNoiseNode>, options);
}

}  // namespace eye_render
