// Nodes of curves and ramps that the host has sampled: Float, Vector and RGB Curves, Color Ramp.

#include "shading/functions/sampled_function.h"
#include "shading/nodes/converter_nodes.h"

#include <array>

namespace eye_render {

namespace {

using enum SocketType;

// Sample `first` and every `stride`th after it, to the end or `count` of them.
[[nodiscard]] std::vector<float> picked(const std::vector<float>& samples,
                                        std::size_t first,
                                        std::size_t stride,
                                        std::size_t count)
{
    std::vector<float> channel;
    channel.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        channel.push_back(samples[first + i * stride]);
    }
    return channel;
}

// Throws std::invalid_argument unless the samples are as many for each channel.
[[nodiscard]] std::size_t samples_per_channel(const std::vector<float>& samples,
                                              const char* option,
                                              std::size_t channels)
{
    if (samples.size() % channels != 0) {
        throw std::invalid_argument(
            std::string(option) + " has " + std::to_string(samples.size()) +
            " numbers; expected a multiple of " + std::to_string(channels));
    }
    return samples.size() / channels;
}

// Curves of one or three channels over one interval.
class Curves {
public:
    Curves(const NodeOptions& options, std::size_t channels)
        : first_(static_cast<float>(options.number("curve_min", 0.0))),
          range_(static_cast<float>(options.number("curve_max", 1.0)) - first_)
    {
        if (!(range_ > 0.0f)) {
            throw std::invalid_argument("curve_max is " + number_text(first_ + range_) +
                                        "; expected more than curve_min, " + number_text(first_));
        }
        const std::vector<float> samples = options.numbers("curve");
        const std::size_t count = samples_per_channel(samples, "curve", channels);
        const Beyond beyond =
            options.is_set("extrapolate", false) ? Beyond::Linear : Beyond::Constant;
        for (std::size_t i = 0; i < channels; ++i) {
            curves_.emplace_back(picked(samples, i * count, 1, count), Between::Linear, beyond);
        }
    }

    // `x` with a share of what the channel's curve makes of it.
    [[nodiscard]] float mixed(std::size_t channel, float x, float factor) const
    {
        return (1.0f - factor) * x + factor * curves_[channel]((x - first_) / range_);
    }

private:
    float first_;
    float range_;
    std::vector<SampledFunction> curves_;
};

class FloatCurveNode final : public ValueNode {
public:
    explicit FloatCurveNode(const NodeOptions& options) : curve_(options, 1) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        out[0] = NodeValue(curve_.mixed(0, in.number(1), in.number(0)));
    }

private:
    Curves curve_;
};

class CurvesNode final : public ValueNode {
public:
    explicit CurvesNode(const NodeOptions& options) : curves_(options, 3) {}

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float factor = in.number(0);
        const V3f v = in.vector(1);
        out[0] = {curves_.mixed(0, v.x, factor), curves_.mixed(1, v.y, factor),
                  curves_.mixed(2, v.z, factor)};
    }

private:
    Curves curves_;
};

class ColorRampNode final : public ValueNode {
public:
    explicit ColorRampNode(const NodeOptions& options)
    {
        const std::vector<float> samples = options.numbers("ramp");
        const std::size_t count = samples_per_channel(samples, "ramp", channels);
        const Between between =
            options.is_set("interpolate", true) ? Between::Linear : Between::Constant;
        for (std::size_t i = 0; i < channels; ++i) {
            ramps_.emplace_back(picked(samples, i, channels, count), between, Beyond::Constant);
        }
    }

    void evaluate(const NodeInputs& in, std::span<NodeValue> out) const override
    {
        const float place = in.number(0);
        out[0] = {ramps_[0](place), ramps_[1](place), ramps_[2](place)};
        if (in.wants(1)) {
            out[1] = NodeValue(ramps_[3](place));
        }
    }

private:
    static constexpr std::size_t channels = 4;

    std::vector<SampledFunction> ramps_;
};

constexpr std::array float_curve_in{number_input("Factor", 1.0f), number_input("Value", 1.0f)};
constexpr std::array vector_curve_in{number_input("Fac", 1.0f), vector_input("Vector")};
constexpr std::array rgb_curve_in{number_input("Fac", 1.0f), color_input("Color", 1.0f)};
constexpr std::array color_ramp_in{number_input("Fac", 0.5f)};
constexpr std::array value_out{OutputSocket{"Value", Number}};
constexpr std::array vector_out{OutputSocket{"Vector", Vector}};
constexpr std::array color_out{OutputSocket{"Color", Color}};
constexpr std::array ramp_out{OutputSocket{"Color", Color}, OutputSocket{"Alpha", Number}};
constexpr std::array<std::string_view, 4> curve_options{"curve", "curve_min", "curve_max",
                                                        "extrapolate"};
constexpr std::array<std::string_view, 2> ramp_options{"ramp", "interpolate"};

}  // namespace

NodeType float_curve_node()
{
    return value_node("CURVE_FLOAT", Reads::InputsAlone, float_curve_in, value_out,
                      make_from_options<FloatCurveNode>, curve_options);
}

NodeType vector_curve_node()
{
    return value_node("CURVE_VEC", Reads::InputsAlone, vector_curve_in, vector_out,
                      make_from_options<CurvesNode>, curve_options);
}

NodeType rgb_curve_node()
{
    return value_node("CURVE_RGB", Reads::InputsAlone, rgb_curve_in, color_out,
                      make_from_options<CurvesNode>, curve_options);
}

NodeType color_ramp_node()
{
    return value_node("VALTORGB", Reads::InputsAlone, color_ramp_in, ramp_out,
                      make_from_options<ColorRampNode>, ramp_options);
}

}  // namespace eye_render
