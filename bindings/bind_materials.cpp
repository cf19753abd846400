// The part of eyecore.Scene that says what surfaces are made of: textures and materials.

#include "bind_scene.h"

#include <optional>

namespace eye_render {

namespace {

struct ImageInput {
    int texture;
    std::string uv_layer;
    Channel channel;
};

struct AttributeInput {
    std::string name;
    Channel channel;
};

Channel channel_named(const std::string& name)
{
    return named<Channel>(
        "channel", name,
        {{"COLOR", Channel::Color}, {"LUMINANCE", Channel::Luminance}, {"ALPHA", Channel::Alpha}});
}

TextureOptions texture_options(const std::string& colorspace,
                               const std::string& extension,
                               const std::string& interpolation)
{
    return {.colorspace = named<Colorspace>("colorspace", colorspace,
                                            {{"sRGB", Colorspace::Srgb},
                                             {"Linear", Colorspace::Linear},
                                             {"Non-Color", Colorspace::NonColor}}),
            .extension = named<Extension>("extension", extension,
                                          {{"REPEAT", Extension::Repeat},
                                           {"EXTEND", Extension::Extend},
                                           {"CLIP", Extension::Clip}}),
            .interpolation = named<Interpolation>(
                "interpolation", interpolation,
                {{"Linear", Interpolation::Linear}, {"Closest", Interpolation::Closest}})};
}

MaterialInput input_from(SceneBuilder& scene, const std::string& name, const py::handle& value)
{
    MaterialInput input;
    if (py::isinstance<ImageInput>(value)) {
        const auto& image = value.cast<const ImageInput&>();
        input.texture = image.texture;
        input.uv_layer = scene.uv_layer(image.uv_layer);
        input.channel = image.channel;
    } else if (py::isinstance<AttributeInput>(value)) {
        const auto& attribute = value.cast<const AttributeInput&>();
        input.color_attribute = scene.color_attribute(attribute.name);
        input.channel = attribute.channel;
    } else if (const auto number = number_from(value)) {
        input.constant = Color3f(static_cast<float>(*number));
    } else {
        input.constant = color_from(name, value);
    }
    return input;
}

std::size_t add_material(SceneBuilder& scene,
                         const std::string& name,
                         const std::string& surface,
                         bool multiple_scattering,
                         const py::kwargs& inputs)
{
    Material material;
    material.name = name;
    material.multiple_scattering = multiple_scattering;
    material.surface = named<Surface>("surface", surface,
                                      {{"PRINCIPLED", Surface::Principled},
                                       {"DIFFUSE", Surface::Diffuse},
                                       {"GLOSSY", Surface::Glossy},
                                       {"GLASS", Surface::Glass},
                                       {"EMISSION", Surface::Emission},
                                       {"TRANSPARENT", Surface::Transparent}});
    for (const auto& [key, value] : inputs) {
        const auto member = named<MaterialInput Material::*>(
            "input of material '" + name + "'", key.cast<std::string>(),
            {{"base_color", &Material::base_color},
             {"metallic", &Material::metallic},
             {"roughness", &Material::roughness},
             {"specular", &Material::specular},
             {"ior", &Material::ior},
             {"transmission", &Material::transmission},
             {"alpha", &Material::alpha},
             {"emission_color", &Material::emission_color},
             {"emission_strength", &Material::emission_strength},
             {"normal_map", &Material::normal_map},
             {"normal_strength", &Material::normal_strength}});
        material.*member = input_from(scene, key.cast<std::string>(), value);
    }
    return scene.add_material(std::move(material));
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

void bind_materials(py::module_& m, SceneClass& scene)
{
    using namespace py::literals;

    py::class_<ImageInput>(m, "ImageInput", "A material input read from a texture of the scene.")
        .def(py::init([](int texture, const std::string& uv_layer, const std::string& channel) {
                 return ImageInput{texture, uv_layer, channel_named(channel)};
             }),
             "texture"_a, "uv_layer"_a = "", "channel"_a = "COLOR");
    py::class_<AttributeInput>(m, "AttributeInput",
                               "A material input read from a colour attribute.")
        .def(py::init([](const std::string& name, const std::string& channel) {
                 return AttributeInput{name, channel_named(channel)};
             }),
             "name"_a, "channel"_a = "COLOR");

    scene
        .def(
            "add_texture",
            [](SceneBuilder& builder, const std::string& path, const std::string& colorspace,
               const std::string& extension, const std::string& interpolation) {
                return builder.textures().add_file(
                    path, texture_options(colorspace, extension, interpolation));
            },
            "path"_a, py::kw_only(), "colorspace"_a = "sRGB", "extension"_a = "REPEAT",
            "interpolation"_a = "Linear",
            "Number of the texture. A file that cannot be read shows magenta and a warning.")
        .def(
            "add_texture_pixels",
            [](SceneBuilder& builder, const std::string& name, const py::array& pixels,
               const std::string& colorspace, const std::string& extension,
               const std::string& interpolation) {
                const auto options = texture_options(colorspace, extension, interpolation);
                if (py::isinstance<py::array_t<std::uint8_t>>(pixels)) {
                    return add_pixels<PixelsU8>(builder, name, Array<std::uint8_t>(pixels),
                                                options);
                }
                return add_pixels<PixelsF32>(builder, name, Array<float>(pixels), options);
            },
            "name"_a, "pixels"_a, py::kw_only(), "colorspace"_a = "sRGB", "extension"_a = "REPEAT",
            "interpolation"_a = "Linear",
            "Number of a texture from pixels (height, width, 4), uint8 or float32, rows "
            "bottom-up.")
        .def("add_material", &add_material, "name"_a, "surface"_a = "PRINCIPLED",
             "multiple_scattering"_a = true,
             "Number of a material; inputs are numbers, colours, ImageInput or AttributeInput.");
}

}  // namespace eye_render
