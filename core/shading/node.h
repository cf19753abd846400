// One kind of shader node, and one node compiled into a program.
//
// A node kind is a row of plain data (NodeType): its sockets under Blender's identifiers, the
// options it knows under Blender's property names, and how to make the evaluated node from them.
// Node kinds live one or a family a file in shading/nodes/ and are listed in node_types.cpp: a new
// one touches its own file and that list.
//
// Values are pulled: a node asks for the inputs it needs, and each node of a program is evaluated
// at most once a hit. A node whose inputs are all constants, and that reads nothing of the hit, is
// evaluated when the program is compiled.

#pragma once

#include "base/working_space.h"
#include "shading/bsdf.h"
#include "shading/hit_attributes.h"
#include "shading/node_options.h"
#include "shading/surface_probe.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

namespace eye_render {

// A number is in x; a vector, or a colour of the scene's working space, is in x, y and z.
using NodeValue = V3f;

enum class SocketType : std::uint8_t { Number, Vector, Color, Shader };

// What an input that nothing is linked to reads in place of its value.
enum class ImplicitInput : std::uint8_t {
    None,
    Generated,
    Uv,
    Normal,
    Position,
    Incoming,      // towards the viewer, unit, in the object's own space
    StrandRandom,  // in [0, 1] by strand; 0 on what is none
};

struct InputSocket {
    std::string_view identifier;
    SocketType type = SocketType::Number;
    NodeValue value{0.0f};
    ImplicitInput implicit = ImplicitInput::None;
};

struct OutputSocket {
    std::string_view identifier;
    SocketType type = SocketType::Number;
    bool reads_active_uv = false;
};

// World-space geometry of a hit, already turned to the viewer: dot(wo, ng) > 0.
struct ShadingPoint {
    V3f wo;                   // unit, towards where the ray came from
    V3f ng;                   // unit geometric normal
    V3f ns;                   // unit interpolated normal
    bool backfacing = false;  // the ray hit the side that the mesh's winding calls its back
    float footprint = 0.0f;   // width that one pixel has here, world units; 0 if nobody knows
};

// How the path came to the hit: what the Light Path node tells.
struct PathState {
    bool is_camera = true;
    bool is_shadow = false;
    bool is_diffuse = false;
    bool is_glossy = false;
    bool is_singular = false;
    bool is_reflection = false;
    bool is_transmission = false;
    bool is_volume_scatter = false;
    bool sees_catchers_only = false;  // as if there were nothing but shadow catchers
    float length = 0.0f;              // from the last scattering, world units
    // The least density, per unit solid angle, with which it was scattered so far: blurry if
    // small.
    float smallest_pdf = std::numeric_limits<float>::max();
    int depth = 0;
    int diffuse_depth = 0;
    int glossy_depth = 0;
    int transparent_depth = 0;
    int transmission_depth = 0;
    int volume_depth = 0;
    // What is off makes no caustics: glossy closures that a diffuse surface would be lit through.
    bool shows_reflections = true;
    bool shows_refractions = true;
};

// All that a program is evaluated from.
struct Hit {
    const ShadingPoint& point;
    const HitAttributes& attributes;
    const PathState& path;
    const SurfaceProbe* probe = nullptr;  // null where no rays may be sent
};

class ParticipatingMedium;
class ProgramRun;
struct ProgramStep;

enum class Conversion : std::uint8_t { None, Splat, Mean, Luminance };

// Where one input gets its value.
struct ProgramInput {
    static constexpr int none = -1;

    NodeValue constant{0.0f};  // of a luminance: the weights of the channels that are computed
    int step = none;           // the step that computes it
    int value = none;          // its place among the values of a run
    ImplicitInput implicit = ImplicitInput::None;
    Conversion conversion = Conversion::None;

    [[nodiscard]] bool is_constant() const
    {
        return step == none && implicit == ImplicitInput::None;
    }
};

// The inputs of one node at one hit.
class NodeInputs {
public:
    NodeInputs(ProgramRun& run, const ProgramStep& step);

    // A colour read as a number is its luminance, a vector read as a number its mean, and a number
    // read as either fills all three: as Blender converts.
    [[nodiscard]] float number(std::size_t input) const
    {
        const ProgramInput& source = inputs_[input];
        return source.is_constant() ? source.constant.x : computed(source).x;
    }
    [[nodiscard]] V3f vector(std::size_t input) const
    {
        const ProgramInput& source = inputs_[input];
        return source.is_constant() ? source.constant : computed(source);
    }
    [[nodiscard]] Color3f color(std::size_t input) const { return vector(input); }

    // The number as it would be at another place of the surface.
    [[nodiscard]] float number_at(std::size_t input, const HitAttributes& attributes) const;

    // False for an output that nobody asks for: it may stay unset.
    [[nodiscard]] bool wants(std::size_t output) const
    {
        return ((wanted_outputs_ >> output) & 1u) != 0;
    }

    [[nodiscard]] const Hit& hit() const;

private:
    // Most inputs of most closures are constant and are read where they are asked for. By a call
    // each, a plain Principled would take 430 instructions more than its 1,160 a shade.
    [[nodiscard]] NodeValue computed(const ProgramInput& source) const;

    ProgramRun& run_;
    const ProgramInput* inputs_;
    std::uint32_t wanted_outputs_;
};

class ValueNode {
public:
    virtual ~ValueNode() = default;
    virtual void evaluate(const NodeInputs& in, std::span<NodeValue> outputs) const = 0;
};

// What is known of a closure's inputs before any hit: its value where it is constant.
using ConstantInputs = std::span<const std::optional<NodeValue>>;

struct ClosureFacts {
    bool may_be_transparent = false;  // light may pass straight through at some hit
    bool may_emit = false;
    int lobes = 0;                                   // added to the mixture at most
    std::optional<std::size_t> subsurface_normal{};  // the input around which light comes out
};

struct ShadedPoint {
    Bsdf bsdf;
    Color3f emission{0.0f};  // radiance towards wo
    float holdout = 0.0f;    // the share that is cut out of the picture

    // Not an aggregate: g++ would clear the room for all lobes first.
    explicit ShadedPoint(const ShadingPoint& point) : bsdf(point.wo, point.ng) {}
};

// A BSDF, an emission or what fills a volume: the leaves of a tree of Mix and Add Shader. `weight`
// is in (0, 1] but for sums, where it may be more.
class ClosureNode {
public:
    virtual ~ClosureNode() = default;

    [[nodiscard]] virtual ClosureFacts facts(ConstantInputs constants) const = 0;

    // Adds what scatters and what shines.
    virtual void shade(const NodeInputs& in, float weight, ShadedPoint& shaded) const = 0;

    // Adds what it is as a volume.
    virtual void fill(const NodeInputs& /*in*/,
                      float /*weight*/,
                      ParticipatingMedium& /*medium*/) const
    {
    }

    // The part of the light that passes straight through, without building the BSDF.
    [[nodiscard]] virtual Color3f straight_transmittance(const NodeInputs& /*in*/) const
    {
        return Color3f(0.0f);
    }

    // Radiance towards the viewer, for light sampling.
    [[nodiscard]] virtual Color3f emission(const NodeInputs& /*in*/) const
    {
        return Color3f(0.0f);
    }
};

// Resources of the scene that nodes name; the scene gives numbers to names.
class NodeResources {
public:
    virtual ~NodeResources() = default;
    // The empty name is a mesh's active layer, and has number HitAttributes::active_uv_layer.
    [[nodiscard]] virtual int uv_layer(const std::string& name) = 0;
    [[nodiscard]] virtual int attribute(const std::string& name) = 0;
    // Throws std::invalid_argument unless there is a texture of that number.
    virtual void require_texture(int texture) = 0;
    [[nodiscard]] virtual WorkingSpace working_space() = 0;  // of all colours
};

enum class NodeRole : std::uint8_t { Value, Closure, MixShader, AddShader };

struct NodeType {
    std::string_view name;  // Blender's node.type: "MATH", "TEX_NOISE", "BSDF_DIFFUSE"
    std::span<const InputSocket> inputs;
    std::span<const OutputSocket> outputs;
    std::span<const std::string_view> options;  // the properties it knows
    NodeRole role = NodeRole::Value;
    bool reads_hit = false;           // false: a function of its inputs alone
    bool reads_object_alone = false;  // what it reads of the hit is the same all over an object
    // The one that fits the role. Throw std::invalid_argument for an option out of range.
    std::unique_ptr<const ValueNode> (*make_value)(const NodeOptions&, NodeResources&) = nullptr;
    std::unique_ptr<const ClosureNode> (*make_closure)(const NodeOptions&,
                                                       NodeResources&) = nullptr;
};

// All node kinds, by name.
[[nodiscard]] std::span<const NodeType* const> node_types();
[[nodiscard]] const NodeType* node_type_named(std::string_view name);

}  // namespace eye_render
