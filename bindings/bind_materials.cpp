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

// Of the graph that `surface` is of, too.
AovsByName aovs_from(const std::map<std::string, NodeSocket>& sockets,
                     const std::optional<NodeSocket>& surface)
{
    AovsByName aovs;
    for (const auto& [name, socket] : sockets) {
        if (!surface || surface->graph != socket.graph) {
            throw std::invalid_argument("AOV '" + name + "' is of another graph than the surface");
        }
        aovs[name] = socket.output;
    }
    return aovs;
}

std::size_t add_material(SceneBuilder& scene,
                         const std::string& name,
                         const std::optional<NodeSocket>& surface,
                         const std::optional<NodeSocket>& displacement,
                         int pass_index,
                         const std::map<std::string, NodeSocket>& aovs)
{
    const NodeGraph nothing;
    const auto output = [](const std::optional<NodeSocket>& socket) {
        return socket ? std::optional(socket->output) : std::nullopt;
    };
    if (surface && displacement && surface->graph != displacement->graph) {
        throw std::invalid_argument("surface and displacement of material '" + name +
                                    "' are of two graphs; expected one");
    }
    const std::optional<NodeSocket>& any = surface ? surface : displacement;
    return scene.add_material(name, any ? *any->graph : nothing, output(surface),
                              output(displacement), pass_index, aovs_from(aovs, any));
}

void set_world(SceneBuilder& scene,
               const py::object& surface,
               const std::map<std::string, NodeSocket>& aovs)
{
    if (py::isinstance<NodeSocket>(surface)) {
        const auto& socket = surface.cast<const NodeSocket&>();
        scene.set_world(*socket.graph, socket.output, aovs_from(aovs, socket));
        return;
    }
    NodeGraph graph;
    const std::size_t background = graph.add("BACKGROUND");
    graph.set(background, "Color", V3f(color_from("world color", surface)));
    scene.set_world(graph, graph.output(background, "Background"));
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
            "Number of the texture. A file that cannot be read shows magenta and a warning.")
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
             "displacement"_a = py::none(), "pass_index"_a = 0, "aovs"_a = py::dict(),
             "Number of a material: outputs of one graph. None is black; displacement is shown as "
             "bump.")
        .def("set_world_light_group", &SceneBuilder::set_world_light_group, "name"_a)
        .def("set_world", &set_world, "surface"_a, "aovs"_a = py::dict(),
             "The light around the scene: an output of a Background node, or one colour.");
}

}  // namespace eye_render
