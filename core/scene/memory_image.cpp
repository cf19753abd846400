#include "scene/memory_image.h"

#include "scene/texel.h"

#include <algorithm>
#include <stdexcept>

namespace eye_render {

namespace {

template <typename T>
MemoryImage from_top_down(int width, int height, std::vector<T> rgba, bool is_associated)
{
    if (is_associated) {
        associate(rgba.data(), rgba.size() / 4);
    }
    return {width, height, std::move(rgba)};
}

template <typename Pixels>
MemoryImage from_bottom_up(const std::string& name, const Pixels& pixels, bool associate)
{
    const auto width = static_cast<std::size_t>(std::max(pixels.width, 0));
    const auto height = static_cast<std::size_t>(std::max(pixels.height, 0));
    const std::size_t row = 4 * width;
    if (row * height == 0 || pixels.rgba.size() != row * height) {
        throw std::invalid_argument("image " + name + " has " +
                                    std::to_string(pixels.rgba.size()) + " values; expected 4 x " +
                                    std::to_string(pixels.width) + " x " +
                                    std::to_string(pixels.height));
    }
    std::vector rgba(pixels.rgba.begin(), pixels.rgba.end());
    for (std::size_t y = 0; y < height; ++y) {
        const auto from = pixels.rgba.subspan((height - 1 - y) * row, row);
        std::copy(from.begin(), from.end(), rgba.data() + y * row);
    }
    return from_top_down(pixels.width, pixels.height, std::move(rgba), associate);
}

}  // namespace

MemoryImage make_memory_image(int width,
                              int height,
                              std::vector<std::uint8_t> rgba,
                              bool associate)
{
    return from_top_down(width, height, std::move(rgba), associate);
}

MemoryImage make_memory_image(int width, int height, std::vector<float> rgba, bool associate)
{
    return from_top_down(width, height, std::move(rgba), associate);
}

MemoryImage make_memory_image(const std::string& name, const PixelsU8& pixels, bool associate)
{
    return from_bottom_up(name, pixels, associate);
}

MemoryImage make_memory_image(const std::string& name, const PixelsF32& pixels)
{
    return from_bottom_up(name, pixels, false);
}

}  // namespace eye_render
