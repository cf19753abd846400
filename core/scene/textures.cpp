#include "scene/textures.h"

#include "scene/texel.h"
#include "scene/texture_cache.h"

#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <stdexcept>

namespace eye_render {

namespace {

Color4f magenta() { return {1.0f, 0.0f, 1.0f, 1.0f}; }

struct Texture {
    std::string name{};
    TextureOptions options{};
    std::optional<CachedImage> image{};  // nothing: magenta
};

// How much of a lookup's footprint lies on the image.
float footprint_coverage(const Texture& texture, float u, float v)
{
    if (texture.options.extension != Extension::Clip) {
        return 1.0f;
    }
    const Interpolation interpolation = texture.options.interpolation;
    const int width = texture.image->width;
    const int height = texture.image->height;
    return coverage(u * static_cast<float>(width), width, interpolation) *
           coverage(v * static_cast<float>(height), height, interpolation);
}

}  // namespace

struct TextureSet::Impl {
    WorkingSpace space;
    std::optional<TextureCache> cache;
    std::vector<Texture> textures;
    std::mutex warnings_mutex;
    std::vector<std::string> warnings;
    std::vector<int> warned;  // textures whose lookup failed

    TextureCache& started_cache() { return cache ? *cache : cache.emplace(); }

    int add(const std::string& name,
            const TextureOptions& options,
            std::optional<CachedImage> image)
    {
        textures.push_back({.name = name, .options = options, .image = image});
        return static_cast<int>(textures.size()) - 1;
    }

    void warn(const std::string& name, const std::string& reason)
    {
        warnings.push_back("Image " + name + " cannot be read and shows magenta: " + reason);
    }

    void warn_lookup(int index)
    {
        const std::string reason = cache->take_error();
        const std::lock_guard lock(warnings_mutex);
        if (std::find(warned.begin(), warned.end(), index) == warned.end()) {
            warned.push_back(index);
            warn(textures[static_cast<std::size_t>(index)].name, reason);
        }
    }

    // Null for an index that was never given out, and for a file that could not be read.
    [[nodiscard]] const Texture* readable(int index) const
    {
        if (index < 0 || index >= static_cast<int>(textures.size())) {
            return nullptr;
        }
        const Texture& texture = textures[static_cast<std::size_t>(index)];
        return texture.image ? &texture : nullptr;
    }
};

TextureSet::TextureSet(WorkingSpace space) : impl_(std::make_unique<Impl>())
{
    impl_->space = space;
}
TextureSet::~TextureSet() = default;
TextureSet::TextureSet(TextureSet&&) noexcept = default;
TextureSet& TextureSet::operator=(TextureSet&&) noexcept = default;

int TextureSet::add_file(const std::string& path, const TextureOptions& options)
{
    std::optional<CachedImage> image;
    try {
        image = impl_->started_cache().add_file(path, options);
    } catch (const std::runtime_error& error) {
        impl_->warn(path, error.what());
    }
    return impl_->add(path, options, image);
}

int TextureSet::add_pixels(const std::string& name,
                           const PixelsU8& pixels,
                           const TextureOptions& options)
{
    MemoryImage image = make_memory_image(name, pixels, options.is_associated());
    return impl_->add(name, options, impl_->started_cache().add_memory(std::move(image), options));
}

int TextureSet::add_pixels(const std::string& name,
                           const PixelsF32& pixels,
                           const TextureOptions& options)
{
    MemoryImage image = make_memory_image(name, pixels);
    return impl_->add(name, options, impl_->started_cache().add_memory(std::move(image), options));
}

Color4f TextureSet::lookup(int texture, const V2f& uv, TextureAlpha use) const
{
    const Texture* t = impl_->readable(texture);
    if (t == nullptr || !std::isfinite(uv.x) || !std::isfinite(uv.y)) {
        return magenta();
    }
    const float u = reduce_coordinate(uv.x, t->options.extension);
    const float v = reduce_coordinate(uv.y, t->options.extension);
    const auto texel = impl_->cache->lookup(*t->image, u, 1.0f - v);
    if (!texel) {
        impl_->warn_lookup(texture);
        return magenta();
    }
    std::array<float, 4> rgba{};
    const float opaque = footprint_coverage(*t, u, v);
    expand_to_rgba(texel->data(), t->image->channels, opaque, rgba.data(), 1);
    Color3f color(rgba[0], rgba[1], rgba[2]);
    const float alpha = t->options.alpha == AlphaChannel::Ignored ? opaque : rgba[3];
    const bool is_divided = use == TextureAlpha::Straight && t->options.is_associated();
    if (is_divided && alpha != 0.0f && alpha != 1.0f) {
        color /= alpha;
    }
    switch (t->options.colorspace) {
    case Colorspace::Srgb: color = rgb_from_rec709(linear_from_srgb(color), impl_->space); break;
    case Colorspace::LinearRec709: color = rgb_from_rec709(color, impl_->space); break;
    default: break;
    }
    return {color.x, color.y, color.z, alpha};
}

int TextureSet::width(int texture) const
{
    const Texture* t = impl_->readable(texture);
    return t == nullptr ? 1 : t->image->width;
}

int TextureSet::size() const { return static_cast<int>(impl_->textures.size()); }

bool TextureSet::started() const { return impl_->cache.has_value(); }

std::vector<std::string> TextureSet::warnings() const
{
    const std::lock_guard lock(impl_->warnings_mutex);
    return impl_->warnings;
}

}  // namespace eye_render
