// What is read from the hit: coordinates, geometry, object, path and view.

#include "shading/bump.h"
#include "shading/fresnel.h"
#include "shading/nodes/make_node.h"
#include "shading/nodes/node_tables.h"
#include "shading/nodes/sockets.h"
#include "shading/view_coordinates.h"

#include <array>
#include <cmath>

namespace eye_render {

namespace {

using enum SocketType;

void light_path(const NodeInputs& in, std::span<NodeValue> out)
{
    const PathState& path = in.hit().path;
    const std::array<float, 14> values{static_cast<float>(path.is_camera),
                                       static_cast<float>(path.is_shadow),
                                       static_cast<float>(path.is_diffuse),
                                       static_cast<float>(path.is_glossy),
                                       static_cast<float>(path.is_singular),
                                       static_cast<float>(path.is_reflection),
                                       static_cast<float>(path.is_transmission),
                                       path.length,
                                       static_cast<float>(path.depth),
                                       static_cast<float>(path.diffuse_depth),
                                       static_cast<float>(path.glossy_depth),
                                       static_cast<float>(path.transparent_depth),
                                       static_cast<float>(path.transmission_depth),
                                       static_cast<float>(path.is_volume_scatter)};
    for (std::size_t i = 0; i < values.size(); ++i) {
        out[i] = NodeValue(values[i]);
    }
}

void object_info(const NodeInputs& in, std::span<NodeValue> out)
{
    const ObjectFacts& object = in.hit().attributes.object();
    out[0] = {object.world_from_object[3][0], object.world_from_object[3][1],
              object.world_from_object[3][2]};
    out[1] = {object.color.r, object.color.g, object.color.b};
    out[2] = NodeValue(object.color.a);
    out[3] = NodeValue(object.pass_index);
    out[4] = NodeValue(object.material_index);
    out[5] = NodeValue(object.random);
}

void camera_data(const NodeInputs& in, std::span<NodeValue> out)
{
    const V3f p = view_position(in.hit().attributes);
    const float distance = p.length();
    out[0] = distance > 0.0f ? p / distance : V3f(0.0f);
    out[1] = NodeValue(p.z);
    out[2] = NodeValue(distance);
}

// cos is taken on the viewer's side, as the normal may be bent away, and is above 1 where it is
// long, as in Cycles.
[[nodiscard]] float reflectance(const NodeInputs& in, const V3f& normal, float ior)
{
    return fresnel_dielectric(std::abs(in.hit().point.wo.dot(normal)), ior).reflectance;
}

void fresnel(const NodeInputs& in, std::span<NodeValue> out)
{
    constexpr float least_ior = 1e-5f;
    const float ior = std::max(in.number(0), least_ior);
    out[0] =
        NodeValue(reflectance(in, in.vector(1), in.hit().point.backfacing ? 1.0f / ior : ior));
}

void layer_weight(const NodeInputs& in, std::span<NodeValue> out)
{
    constexpr float least_rest = 1e-5f;
    const float blend = in.number(0);
    const V3f normal = in.vector(1);
    if (in.wants(0)) {
        const float ior = std::max(1.0f - blend, least_rest);
        out[0] = NodeValue(reflectance(in, normal, in.hit().point.backfacing ? ior : 1.0f / ior));
    }
    if (in.wants(1)) {
        const float clamped = std::clamp(blend, 0.0f, 1.0f - least_rest);
        const float power = clamped < 0.5f ? 2.0f * clamped : 0.5f / (1.0f - clamped);
        out[1] = NodeValue(1.0f - std::pow(std::abs(in.hit().point.wo.dot(normal)), power));
    }
}

// Of a pixel, as it lies on the surface and is seen from the eye: the mean of two steps, whose
// directions are Cycles'.
[[nodiscard]] float pixel_width(const Hit& hit)
{
    const V3f& wo = hit.point.wo;
    float sum = 0.0f;
    for (const V3f& step : bump_offsets(hit.point, hit.attributes.position_world())) {
        sum += (step - wo * wo.dot(step)).length();
    }
    return 0.5f * sum;
}

class WireframeNode final : public ValueNode {
public:
    explicit WireframeNode(bool in_pixels) : in_pixels_(in_pixels) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float width = std::abs(in.number(0)) * (in_pixels_ ? pixel_width(in.hit()) : 1.0f);
        out[0] = NodeValue(in.hit().attributes.edge_distance() < 0.5f * width ? 1.0f : 0.0f);
    }

private:
    bool in_pixels_;
};

constexpr std::array light_path_out{
    OutputSocket{"Is Camera Ray", Number},       OutputSocket{"Is Shadow Ray", Number},
    OutputSocket{"Is Diffuse Ray", Number},      OutputSocket{"Is Glossy Ray", Number},
    OutputSocket{"Is Singular Ray", Number},     OutputSocket{"Is Reflection Ray", Number},
    OutputSocket{"Is Transmission Ray", Number}, OutputSocket{"Ray Length", Number},
    OutputSocket{"Ray Depth", Number},           OutputSocket{"Diffuse Depth", Number},
    OutputSocket{"Glossy Depth", Number},        OutputSocket{"Transparent Depth", Number},
    OutputSocket{"Transmission Depth", Number},  OutputSocket{"Is Volume Scatter Ray", Number}};
constexpr std::array object_info_out{
    OutputSocket{"Location", Vector},       OutputSocket{"Color", Color},
    OutputSocket{"Alpha", Number},          OutputSocket{"Object Index", Number},
    OutputSocket{"Material Index", Number}, OutputSocket{"Random", Number}};
constexpr std::array camera_out{OutputSocket{"View Vector", Vector},
                                OutputSocket{"View Z Depth", Number},
                                OutputSocket{"View Distance", Number}};
constexpr std::array fresnel_in{number_input("IOR", 1.5f), normal_input()};
constexpr std::array layer_weight_in{number_input("Blend", 0.5f), normal_input()};
constexpr std::array layer_weight_out{OutputSocket{"Fresnel", Number},
                                      OutputSocket{"Facing", Number}};
constexpr std::array fac_out{OutputSocket{"Fac", Number}};
constexpr std::array wireframe_in{number_input("Size", 0.01f)};
constexpr std::array wireframe_options{std::string_view("use_pixel_size")};

}  // namespace

std::span<const NodeType> input_nodes()
{
    static const std::array nodes{
        value_node("LIGHT_PATH", Reads::Hit, {}, light_path_out, make_function_node<light_path>),
        value_node("OBJECT_INFO", Reads::Object, {}, object_info_out,
                   make_function_node<object_info>),
        value_node("CAMERA", Reads::Hit, {}, camera_out, make_function_node<camera_data>),
        value_node("FRESNEL", Reads::Hit, fresnel_in, fac_out, make_function_node<fresnel>),
        value_node("LAYER_WEIGHT", Reads::Hit, layer_weight_in, layer_weight_out,
                   make_function_node<layer_weight>),
        value_node(
            "WIREFRAME", Reads::Hit, wireframe_in, fac_out,
            [](const NodeOptions& options,
               NodeResources& /*resources*/) -> std::unique_ptr<const ValueNode> {
                return std::make_unique<WireframeNode>(options.is_set("use_pixel_size", false));
            },
            wireframe_options),
    };
    return nodes;
}

}  // namespace eye_render
