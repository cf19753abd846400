// The part of eyecore.Scene that says what surfaces and the world are made of.

#include "bind_scene.h"

#include <map>
#include <optional>

namespace eye_render {

namespace {

TextureOptions texture_options(const std::string& colorspace,
                               const std::string& extension,
                               const std::string& interpolation,
                               const std::string& alpha)
{
    return {.colorspace = named<Colorspace>("colorspace", colorspace,
                                            {{"sRGB", Colorspace::Srgb},
                                             {"Linear Rec.709", Colorspace::LinearRec709},
                                             {"Linear", Colorspace::Linear},
                                             {"Non-Color", Colorspace::NonColor}}),
            .extension = named<Extension>("extension", extension,
                                          {{"REPEAT", Extension::Repeat},
                                           {"EXTEND", Extension::Extend},
                                           {"CLIP", Extension::Clip}}),
            .interpolation = named<Interpolation>("interpolation", interpolation,
                                                  {{"Linear", Interpolation::Linear},
                                                   {"Closest", Interpolation::Closest},
                                                   {"Cubic", Interpolation::Cubic}}),
            .alpha = named<AlphaChannel>("alpha", alpha,
                                         {{"STRAIGHT", AlphaChannel::Opacity},
                                          {"CHANNEL_PACKED", AlphaChannel::Packed},
                                          {"NONE", AlphaChannel::Ignored}})};
}

// Sockets of one graph, each of which may be missing.
class Outputs {
public:
    explicit Outputs(std::string what) : what_(std::move(what)) {}

    [[nodiscard]] std::optional<NodeOutput> take(const std::optional<NodeSocket>& socket)
    {
        if (!socket) {
            return std::nullopt;
        }
        if (graph_ && graph_ != socket->graph) {
            throw std::invalid_argument("the outputs of " + what_ +
                                        " are of two graphs; expected one");
        }
        graph_ = socket->graph;
        return socket->output;
    }
    [[nodiscard]] AovsByName take(const std::map<std::string, NodeSocket>& sockets)
    {
        AovsByName aovs;
        for (const auto& [name, socket] : sockets) {
            aovs[name] = *take(std::optional(socket));
        }
        return aovs;
    }
    [[nodiscard]] NodeGraph graph() const { return graph_ ? *graph_ : NodeGraph{}; }

private:
    std::string what_;
    std::shared_ptr<const NodeGraph> graph_;
};

std::size_t add_material(SceneBuilder& scene,
                         const std::string& name,
                         const std::optional<NodeSocket>& surface,
                         const std::optional<NodeSocket>& displacement,
                         const std::optional<NodeSocket>& volume,
                         int pass_index,
                         const std::map<std::string, NodeSocket>& aovs)
{
    Outputs outputs("material '" + name + "'");
    const MaterialOutputs taken{.surface = outputs.take(surface),
                                .displacement = outputs.take(displacement),
                                .volume = outputs.take(volume)};
    const AovsByName written = outputs.take(aovs);
    return scene.add_material(name, outputs.graph(), taken, pass_index, written);
}

void set_world(SceneBuilder& scene,
               const py::object& surface,
               const std::optional<NodeSocket>& volume,
               const std::map<std::string, NodeSocket>& aovs)
{
    Outputs outputs("the world");
    MaterialOutputs taken{.volume = outputs.take(volume)};
    if (py::isinstance<NodeSocket>(surface)) {
        taken.surface = outputs.take(surface.cast<NodeSocket>());
        const AovsByName written = outputs.take(aovs);
        scene.set_world(outputs.graph(), taken, written);
        return;
    }
    const AovsByName written = outputs.take(aovs);
    NodeGraph graph = outputs.graph();
    const std::size_t background = graph.add("BACKGROUND");
    graph.set(background, "Color", V3f(color_from("world color", surface)));
    taken.surface = graph.output(background, "Background");
    scene.set_world(graph, taken, written);
}

template <typename Pixels, typename Number>
int add_pixels(SceneBuilder& scene,
               const std::string& name,
               const Array<Number>& pixels,
               const TextureOptions& options)
{
    if (pixels.ndim() != 3 || pixels.shape(2) != 4) {
        throw std::invalid_argument("pixels of '" + name + "' have shape " + shape_text(pixels) +
                                    "; expected (height, width, 4)");
    }
    return scene.textures().add_pixels(
        name,
        Pixels{.width = static_cast<int>(pixels.shape(1)),
               .height = static_cast<int>(pixels.shape(0)),
               .rgba = {pixels.data(), static_cast<std::size_t>(pixels.size())}},
        options);
}

}  // namespace

Color3f color_from(const std::string& name, const py::handle& value)
{
    try {
        const auto c = value.cast<std::array<float, 3>>();
        return {c[0], c[1], c[2]};
    } catch (const py::cast_error&) {
        throw std::invalid_argument(name + " is " + text_of(value) + "; expected three numbers");
    }
}

void bind_materials(SceneClass& scene)
{
    using namespace py::literals;

    scene
        .def(
            "add_texture",
            [](SceneBuilder& builder, const std::string& path, const std::string& colorspace,
               const std::string& extension, const std::string& interpolation,
               const std::string& alpha) {
                return builder.textures().add_file(
                    path, texture_options(colorspace, extension, interpolation, alpha));
            },
            "path"_a, py::kw_only(), "colorspace"_a = "sRGB", "extension"_a = "REPEAT",
            "interpolation"_a = "Linear", "alpha"_a = "STRAIGHT",
            "Number of the texture. A file that cannot be read shows magenta and a warning. What "
            "is\n"
            "Linear is in the scene's working space.")
        .def(
            "add_texture_pixels",
            [](SceneBuilder& builder, const std::string& name, const py::array& pixels,
               const std::string& colorspace, const std::string& extension,
               const std::string& interpolation, const std::string& alpha) {
                const auto options = texture_options(colorspace, extension, interpolation, alpha);
                if (py::isinstance<py::array_t<std::uint8_t>>(pixels)) {
                    return add_pixels<PixelsU8>(builder, name, Array<std::uint8_t>(pixels),
                                                options);
                }
                return add_pixels<PixelsF32>(builder, name, Array<float>(pixels), options);
            },
            "name"_a, "pixels"_a, py::kw_only(), "colorspace"_a = "sRGB", "extension"_a = "REPEAT",
            "interpolation"_a = "Linear", "alpha"_a = "STRAIGHT",
            "Number of a texture from pixels (height, width, 4), rows bottom-up: uint8 with "
            "straight\n"
            "alpha, or float32 multiplied by it.")
        .def("add_material", &add_material, "name"_a, "surface"_a = py::none(),
             "displacement"_a = py::none(), "volume"_a = py::none(), "pass_index"_a = 0,
             "aovs"_a = py::dict(),
             "Number of a material: outputs of one graph. A surface of None is black, or clear "
             "around\n"
             "a volume, which is what fills a closed mesh; displacement is shown as bump.")
        .def("set_world_light_group", &SceneBuilder::set_world_light_group, "name"_a)
        .def(
            "set_world_visibility",
            [](SceneBuilder& builder, const std::vector<std::string>& hidden_from) {
                builder.set_world_visibility(visibility_from(hidden_from));
            },
            "hidden_from"_a,
            "The kinds of rays that the world's light is hidden from, as add_instances names "
            "them.")
        .def("set_world", &set_world, "surface"_a, "volume"_a = py::none(), "aovs"_a = py::dict(),
             "The light around the scene: an output of a Background node, or one colour; and what "
             "the\n"
             "scene is full of.");
}

}  // namespace eye_render
