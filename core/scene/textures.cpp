// Files go through OpenImageIO's cache as they are. Pixels, and files whose colour is not yet
// multiplied by alpha (PNG), are kept in memory here with alpha multiplied in, in the encoded
// values and rounded down as Cycles does, and reach the cache through an ImageInput of our own:
// whatever the cache evicts, it can read again.

#include "scene/textures.h"

#include "scene/texel.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <mutex>
#include <stdexcept>

namespace eye_render {

namespace {

// Raw pointers in OpenImageIO 2, shared ones from 3.0 on.
using CachePointer = decltype(OIIO::ImageCache::create(false));
using SystemPointer = decltype(OIIO::TextureSystem::create(false));

constexpr float cache_size_mb = 4096.0f;
const char* const memory_attribute = "eye:memory_image";

Color4f magenta() { return {1.0f, 0.0f, 1.0f, 1.0f}; }

// RGBA, rows top-down as OpenImageIO counts them.
struct MemoryImage {
    int width = 0;
    int height = 0;
    OIIO::TypeDesc format;
    std::vector<std::byte> bytes;
};

// Reads a MemoryImage, whose address the configuration carries.
class MemoryInput final : public OIIO::ImageInput {
public:
    [[nodiscard]] const char* format_name() const override { return "eye_memory"; }

    bool open(const std::string& /*name*/, OIIO::ImageSpec& /*new_spec*/) override
    {
        return false;
    }

    bool open(const std::string& /*name*/,
              OIIO::ImageSpec& new_spec,
              const OIIO::ImageSpec& config) override
    {
        const auto* parameter = config.find_attribute(memory_attribute, OIIO::TypeDesc::PTR);
        if (parameter == nullptr) {
            return false;
        }
        image_ = *static_cast<const MemoryImage* const*>(parameter->data());
        m_spec = OIIO::ImageSpec(image_->width, image_->height, 4, image_->format);
        new_spec = m_spec;
        return true;
    }

    bool close() override { return true; }

    bool read_native_scanline(int /*subimage*/,
                              int /*miplevel*/,
                              int y,
                              int /*z*/,
                              void* data) override
    {
        const std::size_t row_bytes =
            image_->bytes.size() / static_cast<std::size_t>(image_->height);
        const auto* row = image_->bytes.data() + static_cast<std::size_t>(y) * row_bytes;
        std::copy_n(row, row_bytes, static_cast<std::byte*>(data));
        return true;
    }

private:
    const MemoryImage* image_ = nullptr;
};

struct Texture {
    OIIO::TextureSystem::TextureHandle* handle = nullptr;  // null: magenta
    OIIO::ustring name{};                                  // in the cache
    OIIO::TextureOpt lookup_options{};
    TextureOptions options{};
    int width = 0;
    int height = 0;
    int channels = 0;         // looked up: 1 to 4
    bool associated = false;  // divide colour by alpha after interpolation
};

OIIO::TextureOpt lookup_options(const TextureOptions& options)
{
    OIIO::TextureOpt result;
    result.mipmode = OIIO::TextureOpt::MipModeNoMIP;
    result.interpmode = options.interpolation == Interpolation::Linear
                            ? OIIO::TextureOpt::InterpBilinear
                            : OIIO::TextureOpt::InterpClosest;
    switch (options.extension) {
    case Extension::Repeat: result.swrap = OIIO::TextureOpt::WrapPeriodic; break;
    case Extension::Extend: result.swrap = OIIO::TextureOpt::WrapClamp; break;
    case Extension::Clip: result.swrap = OIIO::TextureOpt::WrapBlack; break;
    }
    result.twrap = result.swrap;
    return result;
}

}  // namespace

struct TextureSet::Impl {
    std::vector<std::unique_ptr<MemoryImage>> images;  // outlives the system that reads it
    CachePointer cache{};
    SystemPointer system{};
    std::vector<Texture> textures;
    std::mutex warnings_mutex;
    std::vector<std::string> warnings;
    std::vector<int> warned;  // textures whose lookup failed

    ~Impl()
    {
        // The system is not destroyed: OpenImageIO 2 would delete it by the size of its base
        // class, which ruins the heap of an allocator that believes it, such as Blender's. That
        // leaves 184 bytes; all else it holds is the cache's. From 3.0 on it goes by itself.
        if (cache) {
            OIIO::ImageCache::destroy(cache);
        }
    }

    void start()
    {
        if (system) {
            return;
        }
        cache = OIIO::ImageCache::create(false);
        system = OIIO::TextureSystem::create(false, cache);
        system->attribute("max_memory_MB", cache_size_mb);
        system->attribute("unassociatedalpha", 1);
    }

    int add(Texture texture)
    {
        texture.lookup_options = lookup_options(texture.options);
        textures.push_back(texture);
        return static_cast<int>(textures.size()) - 1;
    }

    int add_memory(std::unique_ptr<MemoryImage> image, const TextureOptions& options)
    {
        start();
        const OIIO::ustring name("eye_memory_" + std::to_string(images.size()));
        const MemoryImage* address = image.get();
        OIIO::ImageSpec config;
        config.attribute(memory_attribute, OIIO::TypeDesc::PTR, &address);
        const OIIO::ImageInput::Creator create = []() -> OIIO::ImageInput* {
            return new MemoryInput;
        };
        system->imagecache()->add_file(name, create, &config);
        images.push_back(std::move(image));
        return add({.handle = system->get_texture_handle(name),
                    .name = name,
                    .options = options,
                    .width = address->width,
                    .height = address->height,
                    .channels = 4,
                    .associated = options.colorspace != Colorspace::NonColor});
    }

    template <typename T>
    std::unique_ptr<MemoryImage> memory_image(int width,
                                              int height,
                                              const T* rgba,
                                              Colorspace space)
    {
        auto image = std::make_unique<MemoryImage>();
        const std::size_t pixels =
            static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        image->width = width;
        image->height = height;
        image->format = OIIO::BaseTypeFromC<T>::value;
        image->bytes.resize(pixels * 4 * sizeof(T));
        T* out = reinterpret_cast<T*>(image->bytes.data());
        std::copy_n(rgba, 4 * pixels, out);
        if (space != Colorspace::NonColor) {
            associate(out, pixels);
        }
        return image;
    }

    template <typename T>
    int add_pixels(const std::string& name,
                   int width,
                   int height,
                   std::span<const T> rgba,
                   const TextureOptions& options)
    {
        const bool fits =
            width > 0 && height > 0 &&
            rgba.size() == 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
        if (!fits) {
            throw std::invalid_argument("image " + name + " has " + std::to_string(rgba.size()) +
                                        " values; expected 4 x " + std::to_string(width) + " x " +
                                        std::to_string(height));
        }
        auto image = memory_image(width, height, rgba.data(), options.colorspace);
        const std::size_t row = image->bytes.size() / static_cast<std::size_t>(height);
        for (int y = 0; y < height / 2; ++y) {
            const auto top = image->bytes.begin() + static_cast<std::ptrdiff_t>(row) * y;
            const auto bottom =
                image->bytes.begin() + static_cast<std::ptrdiff_t>(row) * (height - 1 - y);
            std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
        }
        return add_memory(std::move(image), options);
    }

    int add_magenta(const std::string& path, const std::string& reason)
    {
        warnings.push_back("Image " + path + " cannot be read and shows magenta: " + reason);
        return add({});
    }

    template <typename T>
    int add_straight_file(OIIO::ImageInput& input,
                          const std::string& path,
                          T opaque,
                          const TextureOptions& options)
    {
        const OIIO::ImageSpec& spec = input.spec();
        const std::size_t pixels =
            static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
        std::vector<T> values(pixels * static_cast<std::size_t>(spec.nchannels));
        if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<T>::value,
                              values.data())) {
            return add_magenta(path, input.geterror());
        }
        std::vector<T> rgba(pixels * 4);
        expand_to_rgba(values.data(), spec.nchannels, opaque, rgba.data(), pixels);
        return add_memory(memory_image(spec.width, spec.height, rgba.data(), options.colorspace),
                          options);
    }

    void warn_lookup(int index)
    {
        const std::string reason = system->geterror();
        const std::lock_guard lock(warnings_mutex);
        if (std::find(warned.begin(), warned.end(), index) == warned.end()) {
            warned.push_back(index);
            warnings.push_back("Image " + textures[static_cast<std::size_t>(index)].name.string() +
                               " cannot be read and shows magenta: " + reason);
        }
    }
};

TextureSet::TextureSet() : impl_(std::make_unique<Impl>()) {}
TextureSet::~TextureSet() = default;
TextureSet::TextureSet(TextureSet&&) noexcept = default;
TextureSet& TextureSet::operator=(TextureSet&&) noexcept = default;

int TextureSet::add_file(const std::string& path, const TextureOptions& options)
{
    impl_->start();
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) {
        return impl_->add_magenta(path, OIIO::geterror());
    }
    const OIIO::ImageSpec& spec = input->spec();
    const bool has_alpha = spec.nchannels == 2 || spec.nchannels > 3;
    const bool is_color = options.colorspace != Colorspace::NonColor;
    if (has_alpha && is_color && spec.get_int_attribute("oiio:UnassociatedAlpha") != 0) {
        return spec.format == OIIO::TypeDesc::UINT8
                   ? impl_->add_straight_file<std::uint8_t>(*input, path, 255, options)
                   : impl_->add_straight_file<float>(*input, path, 1.0f, options);
    }
    const OIIO::ustring name(path);
    return impl_->add({.handle = impl_->system->get_texture_handle(name),
                       .name = name,
                       .options = options,
                       .width = spec.width,
                       .height = spec.height,
                       .channels = std::min(spec.nchannels, 4),
                       .associated = is_color});
}

int TextureSet::add_pixels(const std::string& name,
                           const PixelsU8& pixels,
                           const TextureOptions& options)
{
    return impl_->add_pixels(name, pixels.width, pixels.height, pixels.rgba, options);
}

int TextureSet::add_pixels(const std::string& name,
                           const PixelsF32& pixels,
                           const TextureOptions& options)
{
    return impl_->add_pixels(name, pixels.width, pixels.height, pixels.rgba, options);
}

Color4f TextureSet::lookup(int texture, const V2f& uv) const
{
    if (texture < 0 || texture >= size() || !std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        return magenta();
    }
    const Texture& t = impl_->textures[static_cast<std::size_t>(texture)];
    if (t.handle == nullptr) {
        return magenta();
    }
    const Extension extension = t.options.extension;
    const float u = reduce_coordinate(uv.x, extension);
    const float v = reduce_coordinate(uv.y, extension);
    OIIO::TextureOpt options = t.lookup_options;
    std::array<float, 4> texel{};
    // OpenImageIO counts rows from the top.
    if (!impl_->system->texture(t.handle, nullptr, options, u, 1.0f - v, 0, 0, 0, 0, t.channels,
                                texel.data())) {
        impl_->warn_lookup(texture);
        return magenta();
    }
    float opaque = 1.0f;
    if (extension == Extension::Clip) {
        const Interpolation interpolation = t.options.interpolation;
        opaque = coverage(u * static_cast<float>(t.width), t.width, interpolation) *
                 coverage(v * static_cast<float>(t.height), t.height, interpolation);
    }
    std::array<float, 4> rgba{};
    expand_to_rgba(texel.data(), t.channels, opaque, rgba.data(), 1);
    Color3f color(rgba[0], rgba[1], rgba[2]);
    const float alpha = rgba[3];
    if (t.associated && alpha != 0.0f && alpha != 1.0f) {
        color /= alpha;
    }
    if (t.options.colorspace == Colorspace::Srgb) {
        color = {linear_from_srgb(color.x), linear_from_srgb(color.y), linear_from_srgb(color.z)};
    }
    return {color.x, color.y, color.z, alpha};
}

LinearPixels TextureSet::load_linear_pixels(int texture, int max_width) const
{
    LinearPixels result{1, 1, {Color3f(1.0f, 0.0f, 1.0f)}};
    const Texture* t = texture >= 0 && texture < size()
                           ? &impl_->textures[static_cast<std::size_t>(texture)]
                           : nullptr;
    if (t == nullptr || t->handle == nullptr) {
        return result;
    }
    result.width = std::clamp(max_width, 1, t->width);
    result.height = std::clamp(
        static_cast<int>(std::lround(double(t->height) * result.width / t->width)), 1, t->height);
    result.rgb.assign(static_cast<std::size_t>(result.width) *
                          static_cast<std::size_t>(result.height),
                      Color3f(0.0f));
    const auto& cache = impl_->system->imagecache();
    // Each row of the result is the box-filtered mean of a band of whole rows of the image.
    const auto shrink_row = [&](int row) {
        const int y0 = static_cast<int>(std::int64_t(row) * t->height / result.height);
        const int y1 = static_cast<int>(std::int64_t(row + 1) * t->height / result.height);
        const auto channels = static_cast<std::size_t>(t->channels);
        std::vector<float> band(static_cast<std::size_t>(t->width) *
                                static_cast<std::size_t>(y1 - y0) * channels);
        if (!cache->get_pixels(t->name, 0, 0, 0, t->width, y0, y1, 0, 1, 0, t->channels,
                               OIIO::TypeDesc::FLOAT, band.data())) {
            return;
        }
        Color3f* out = &result.rgb[static_cast<std::size_t>(result.height - 1 - row) *
                                   static_cast<std::size_t>(result.width)];
        for (int x = 0; x < result.width; ++x) {
            const int x0 = static_cast<int>(std::int64_t(x) * t->width / result.width);
            const int x1 = static_cast<int>(std::int64_t(x + 1) * t->width / result.width);
            Color3f sum(0.0f);
            for (int y = 0; y < y1 - y0; ++y) {
                for (int i = x0; i < x1; ++i) {
                    std::array<float, 4> rgba{};
                    expand_to_rgba(
                        &band[(static_cast<std::size_t>(y) * static_cast<std::size_t>(t->width) +
                               static_cast<std::size_t>(i)) *
                              channels],
                        t->channels, 1.0f, rgba.data(), 1);
                    const bool srgb = t->options.colorspace == Colorspace::Srgb;
                    const Color3f encoded(rgba[0], rgba[1], rgba[2]);
                    sum += srgb ? Color3f(linear_from_srgb(encoded.x), linear_from_srgb(encoded.y),
                                          linear_from_srgb(encoded.z))
                                : encoded;
                }
            }
            out[x] = sum / static_cast<float>((y1 - y0) * (x1 - x0));
        }
    };
    tbb::parallel_for(tbb::blocked_range<int>(0, result.height, 8), [&](const auto& rows) {
        for (int row = rows.begin(); row != rows.end(); ++row) {
            shrink_row(row);
        }
    });
    return result;
}

int TextureSet::size() const { return static_cast<int>(impl_->textures.size()); }

bool TextureSet::started() const { return bool(impl_->system); }

std::vector<std::string> TextureSet::warnings() const
{
    const std::lock_guard lock(impl_->warnings_mutex);
    return impl_->warnings;
}

}  // namespace eye_render
