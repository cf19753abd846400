#include "scene/texture_cache.h"

#include "scene/texel.h"

#include <OpenImageIO/imagecache.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/texture.h>
#include <tbb/enumerable_thread_specific.h>

#include <stdexcept>

namespace eye_render {

namespace {

// Raw pointers in OpenImageIO 2, shared ones from 3.0 on.
using CachePointer = decltype(OIIO::ImageCache::create(false));
using SystemPointer = decltype(OIIO::TextureSystem::create(false));

constexpr float cache_size_mb = 4096.0f;
const char* const memory_attribute = "eye:memory_image";

template <typename T>
OIIO::TypeDesc format_of(const std::vector<T>& /*values*/)
{
    return OIIO::BaseTypeFromC<T>::value;
}

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
        const OIIO::TypeDesc format =
            std::visit([](const auto& rgba) { return format_of(rgba); }, image_->rgba);
        m_spec = OIIO::ImageSpec(image_->width, image_->height, 4, format);
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
        const std::size_t row = 4 * static_cast<std::size_t>(image_->width);
        const std::size_t first = static_cast<std::size_t>(y) * row;
        const auto copy_row = [&]<typename T>(const std::vector<T>& rgba) {
            std::copy_n(rgba.data() + first, row, static_cast<T*>(data));
        };
        std::visit(copy_row, image_->rgba);
        return true;
    }

private:
    const MemoryImage* image_ = nullptr;
};

OIIO::TextureOpt lookup_options(const TextureOptions& options)
{
    OIIO::TextureOpt result;
    result.mipmode = OIIO::TextureOpt::MipModeNoMIP;
    switch (options.interpolation) {
    case Interpolation::Linear: result.interpmode = OIIO::TextureOpt::InterpBilinear; break;
    case Interpolation::Closest: result.interpmode = OIIO::TextureOpt::InterpClosest; break;
    case Interpolation::Cubic: result.interpmode = OIIO::TextureOpt::InterpBicubic; break;
    }
    switch (options.extension) {
    case Extension::Repeat: result.swrap = OIIO::TextureOpt::WrapPeriodic; break;
    case Extension::Extend: result.swrap = OIIO::TextureOpt::WrapClamp; break;
    case Extension::Clip: result.swrap = OIIO::TextureOpt::WrapBlack; break;
    }
    result.twrap = result.swrap;
    return result;
}

// The whole of an open file whose alpha is straight.
template <typename T>
MemoryImage read_straight(OIIO::ImageInput& input, T opaque)
{
    const OIIO::ImageSpec& spec = input.spec();
    const std::size_t pixels =
        static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height);
    std::vector<T> values(pixels * static_cast<std::size_t>(spec.nchannels));
    if (!input.read_image(0, 0, 0, spec.nchannels, OIIO::BaseTypeFromC<T>::value, values.data())) {
        throw std::runtime_error(input.geterror());
    }
    std::vector<T> rgba(pixels * 4);
    expand_to_rgba(values.data(), spec.nchannels, opaque, rgba.data(), pixels);
    return make_memory_image(spec.width, spec.height, std::move(rgba), true);
}

}  // namespace

struct TextureCache::Impl {
    using ThreadInfo = OIIO::TextureSystem::Perthread;
    struct Entry {
        OIIO::TextureSystem::TextureHandle* handle = nullptr;
        OIIO::ustring name{};
        OIIO::TextureOpt options{};
    };

    std::vector<std::unique_ptr<MemoryImage>> images;  // outlives the system that reads it
    CachePointer cache = OIIO::ImageCache::create(false);
    SystemPointer system = OIIO::TextureSystem::create(false, cache);
    std::vector<Entry> entries;
    // Left to itself, OpenImageIO 2 keeps a thread's state under the address of the cache, beyond
    // the cache's end: the thread would find dead images in the next cache at that address.
    mutable tbb::enumerable_thread_specific<ThreadInfo*> thread_infos{
        [this] { return system->create_thread_info(); }};

    Impl()
    {
        system->attribute("max_memory_MB", cache_size_mb);
        system->attribute("unassociatedalpha", 1);
    }

    Impl(const Impl&) = delete;
    Impl& operator=(const Impl&) = delete;

    ~Impl()
    {
        for (ThreadInfo* info : thread_infos) {
            system->destroy_thread_info(info);
        }
        // The system is not destroyed: OpenImageIO 2 would delete it by the size of its base
        // class, which ruins the heap of an allocator that believes it, such as Blender's. That
        // leaves 184 bytes; all else it holds is the cache's. From 3.0 on it goes by itself.
        OIIO::ImageCache::destroy(cache);
    }

    int add(const OIIO::ustring& name, const TextureOptions& options)
    {
        entries.push_back({.handle = system->get_texture_handle(name, thread_infos.local()),
                           .name = name,
                           .options = lookup_options(options)});
        return static_cast<int>(entries.size()) - 1;
    }

    [[nodiscard]] const Entry& entry(const CachedImage& image) const
    {
        return entries[static_cast<std::size_t>(image.number)];
    }
};

TextureCache::TextureCache() : impl_(std::make_unique<Impl>()) {}
TextureCache::~TextureCache() = default;

CachedImage TextureCache::add_file(const std::string& path, const TextureOptions& options)
{
    OIIO::ImageSpec config;
    config.attribute("oiio:UnassociatedAlpha", 1);
    const auto input = OIIO::ImageInput::open(path, &config);
    if (!input) {
        throw std::runtime_error(OIIO::geterror());
    }
    const OIIO::ImageSpec& spec = input->spec();
    const bool has_alpha = spec.nchannels == 2 || spec.nchannels > 3;
    const bool is_straight = spec.get_int_attribute("oiio:UnassociatedAlpha") != 0;
    if (has_alpha && is_straight && options.is_associated()) {
        return add_memory(spec.format == OIIO::TypeDesc::UINT8
                              ? read_straight<std::uint8_t>(*input, 255)
                              : read_straight<float>(*input, 1.0f),
                          options);
    }
    return {.number = impl_->add(OIIO::ustring(path), options),
            .width = spec.width,
            .height = spec.height,
            .channels = std::min(spec.nchannels, 4)};
}

CachedImage TextureCache::add_memory(MemoryImage image, const TextureOptions& options)
{
    const OIIO::ustring name("eye_memory_" + std::to_string(impl_->images.size()));
    impl_->images.push_back(std::make_unique<MemoryImage>(std::move(image)));
    const MemoryImage* address = impl_->images.back().get();
    OIIO::ImageSpec config;
    config.attribute(memory_attribute, OIIO::TypeDesc::PTR, &address);
    const OIIO::ImageInput::Creator create = []() -> OIIO::ImageInput* { return new MemoryInput; };
    // To replace is to leave this thread's state out, which may be an earlier cache's.
    impl_->cache->add_file(name, create, &config, true);
    return {.number = impl_->add(name, options),
            .width = address->width,
            .height = address->height,
            .channels = 4};
}

std::optional<std::array<float, 4>> TextureCache::lookup(const CachedImage& image,
                                                         float u,
                                                         float v) const
{
    const Impl::Entry& entry = impl_->entry(image);
    OIIO::TextureOpt options = entry.options;
    std::array<float, 4> texel{};
    if (!impl_->system->texture(entry.handle, impl_->thread_infos.local(), options, u, v, 0, 0, 0,
                                0, image.channels, texel.data())) {
        return std::nullopt;
    }
    return texel;
}

std::string TextureCache::take_error() const { return impl_->system->geterror(); }

}  // namespace eye_render
