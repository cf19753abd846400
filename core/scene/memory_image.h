// Images that live in memory: as a host hands them over, and as the texture cache reads them.

#pragma once

#include "scene/texture_options.h"

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace eye_render {

// RGBA with straight alpha, rows bottom-up, as Blender hands over packed and generated images.
// The values are encoded as the colour space says; they are copied.
struct PixelsU8 {
    int width = 0;
    int height = 0;
    std::span<const std::uint8_t> rgba;
};
struct PixelsF32 {
    int width = 0;
    int height = 0;
    std::span<const float> rgba;
};

// RGBA, rows top-down; unless it is data, alpha is multiplied into the encoded colour (and whole
// numbers rounded down), as Cycles does.
struct MemoryImage {
    int width = 0;
    int height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<float>> rgba;
};

// From straight alpha with the rows top-down already. `rgba` has 4 width height values.
[[nodiscard]] MemoryImage make_memory_image(int width,
                                            int height,
                                            std::vector<std::uint8_t> rgba,
                                            Colorspace colorspace);
[[nodiscard]] MemoryImage make_memory_image(int width,
                                            int height,
                                            std::vector<float> rgba,
                                            Colorspace colorspace);

// Throws std::invalid_argument for pixels whose count does not fit their size; `name` is the
// image's in that text.
[[nodiscard]] MemoryImage make_memory_image(const std::string& name,
                                            const PixelsU8& pixels,
                                            Colorspace colorspace);
[[nodiscard]] MemoryImage make_memory_image(const std::string& name,
                                            const PixelsF32& pixels,
                                            Colorspace colorspace);

}  // namespace eye_render
