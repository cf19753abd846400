// Voronoi Texture.

#include "shading/nodes/procedural_nodes.h"
#include "shading/procedural/voronoi.h"

#include <array>

namespace eye_render {

namespace {

class VoronoiNode final : public ValueNode {
public:
    enum Input : std::size_t {
        Vector,
        WIn,
        Scale,
        Detail,
        Roughness,
        Lacunarity,
        Smoothness,
        Exponent,
        Randomness
    };
    enum Output : std::size_t { Distance, Color, Position, WOut, Radius };

    explicit VoronoiNode(const NodeOptions& options)
        : dimensions_(dimensions_of(options, "voronoi_dimensions")),
          feature_(options.choice<VoronoiFeature>(
              "feature",
              {{"F1", VoronoiFeature::F1},
               {"F2", VoronoiFeature::F2},
               {"SMOOTH_F1", VoronoiFeature::SmoothF1},
               {"DISTANCE_TO_EDGE", VoronoiFeature::DistanceToEdge},
               {"N_SPHERE_RADIUS", VoronoiFeature::NSphereRadius}})),
          metric_(options.choice<VoronoiMetric>("distance",
                                                {{"EUCLIDEAN", VoronoiMetric::Euclidean},
                                                 {"MANHATTAN", VoronoiMetric::Manhattan},
                                                 {"CHEBYCHEV", VoronoiMetric::Chebychev},
                                                 {"MINKOWSKI", VoronoiMetric::Minkowski}})),
          is_normalized_(options.is_set("normalize", false))
    {
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const Voronoi voronoi{.feature = feature_,
                              .metric = metric_,
                              .exponent = in.number(Exponent),
                              .randomness = in.number(Randomness),
                              .is_normalized = is_normalized_,
                              .scale = in.number(Scale),
                              .detail = in.number(Detail),
                              .roughness = in.number(Roughness),
                              .lacunarity = in.number(Lacunarity),
                              .smoothness = in.number(Smoothness)};
        const VoronoiAnswer answer =
            in_dimensions(dimensions_, in, Vector, WIn,
                          [&](const auto& p) { return voronoi_texture(p, voronoi); });
        out[Distance] = NodeValue(answer.distance);
        out[Color] = answer.color;
        out[Position] = answer.position;
        out[WOut] = NodeValue(answer.w);
        out[Radius] = NodeValue(answer.radius);
    }

private:
    int dimensions_;
    VoronoiFeature feature_;
    VoronoiMetric metric_;
    bool is_normalized_;
};

}  // namespace

NodeType voronoi_texture_node()
{
    static constexpr std::array inputs{texture_vector,
                                       number_input("W"),
                                       number_input("Scale", 5.0f),
                                       number_input("Detail"),
                                       number_input("Roughness", 0.5f),
                                       number_input("Lacunarity", 2.0f),
                                       number_input("Smoothness", 1.0f),
                                       number_input("Exponent", 0.5f),
                                       number_input("Randomness", 1.0f)};
    static constexpr std::array outputs{
        OutputSocket{"Distance"}, OutputSocket{"Color", SocketType::Color},
        OutputSocket{"Position", SocketType::Vector}, OutputSocket{"W"}, OutputSocket{"Radius"}};
    static constexpr std::array<std::string_view, 4> options{"voronoi_dimensions", "feature",
                                                             "distance", "normalize"};
    return value_node("TEX_VORONOI", Reads::InputsAlone, inputs, outputs,
                      make_from_options<VoronoiNode>, options);
}

}  // namespace eye_render
