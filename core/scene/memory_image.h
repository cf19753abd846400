// Images that live in memory: as a host hands them over, and as the texture cache reads them.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace eye_render {

// RGBA, rows bottom-up, as Blender hands over packed and generated images: whole numbers with
// straight alpha, and others multiplied by it. The values are encoded as the colour space says;
// they are copied.
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

// RGBA, rows top-down.
struct MemoryImage {
    int width = 0;
    int height = 0;
    std::variant<std::vector<std::uint8_t>, std::vector<float>> rgba;
};

// From straight alpha with the rows top-down already. `rgba` has 4 width height values. To
// associate is to multiply alpha into the encoded colour, whole numbers rounded down, as Cycles
// does.
[[nodiscard]] MemoryImage make_memory_image(int width,
                                            int height,
                                            std::vector<std::uint8_t> rgba,
                                            bool associate);
[[nodiscard]] MemoryImage make_memory_image(int width,
                                            int height,
                                            std::vector<float> rgba,
                                            bool associate);

// Throws std::invalid_argument for pixels whose count does not fit their size; `name` is the
// image's in that text.
[[nodiscard]] MemoryImage make_memory_image(const std::string& name,
                                            const PixelsU8& pixels,
                                            bool associate);
[[nodiscard]] MemoryImage make_memory_image(const std::string& name, const PixelsF32& pixels);

}  // namespace eye_render
