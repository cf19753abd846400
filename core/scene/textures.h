// Image textures: a private OpenImageIO texture system behind a small interface; the only part
// of the project that knows OpenImageIO.
//
// A lookup is bilinear on the full-resolution image, without MIP maps, as Cycles does, and gives
// linear Rec. 709 with straight alpha. v = 0 is the bottom row, v = 1 the top one. sRGB is
// decoded after interpolation, and alpha is divided out after interpolation, both as Cycles does
// for 8-bit images. OpenImageIO is not started before the first image is added.

#pragma once

#include "base/vector.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace eye_render {

enum class Colorspace { Srgb, Linear, NonColor };  // NonColor: as Linear, and alpha is left alone
enum class Extension { Repeat, Extend, Clip };     // Clip: transparent black outside
enum class Interpolation { Linear, Closest };

struct TextureOptions {
    Colorspace colorspace = Colorspace::Srgb;
    Extension extension = Extension::Repeat;
    Interpolation interpolation = Interpolation::Linear;
};

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

// A small linear copy of an image, rows bottom-up, for tables.
struct LinearPixels {
    int width = 0;
    int height = 0;
    std::vector<Color3f> rgb;
};

class TextureSet {
public:
    TextureSet();
    ~TextureSet();
    TextureSet(TextureSet&& other) noexcept;
    TextureSet& operator=(TextureSet&& other) noexcept;

    // Each returns the texture's index. A file that cannot be read becomes magenta and adds a
    // warning; pixels whose count does not fit their size throw std::invalid_argument.
    int add_file(const std::string& path, const TextureOptions& options);
    int add_pixels(const std::string& name, const PixelsU8& pixels, const TextureOptions& options);
    int add_pixels(const std::string& name,
                   const PixelsF32& pixels,
                   const TextureOptions& options);

    // Safe from any number of threads once everything is added. Finite for finite files and uv;
    // an index that was never given out, or uv that is not finite, gives magenta.
    [[nodiscard]] Color4f lookup(int texture, const V2f& uv) const;

    // The image shrunk by box filtering to at most `max_width` pixels wide, aspect kept.
    [[nodiscard]] LinearPixels load_linear_pixels(int texture, int max_width) const;

    [[nodiscard]] int size() const;
    [[nodiscard]] bool started() const;  // whether OpenImageIO's texture system exists
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace eye_render
