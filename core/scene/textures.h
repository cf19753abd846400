// Image textures, of files and of pixels in memory.
//
// A lookup is interpolated on the full-resolution image, without MIP maps, as Cycles does, and
// gives colours of the working space. v = 0 is the bottom row, v = 1 the top one. Alpha is divided
// out after interpolation, and colours are converted after that, as Cycles does. OpenImageIO is
// not started before the first image is added.

#pragma once

#include "base/working_space.h"
#include "scene/memory_image.h"
#include "scene/texture_options.h"
#include "shading/hit_attributes.h"

#include <memory>
#include <string>
#include <vector>

namespace eye_render {

class TextureSet {
public:
    explicit TextureSet(WorkingSpace space = WorkingSpace::Rec709);
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
    [[nodiscard]] Color4f lookup(int texture,
                                 const V2f& uv,
                                 TextureAlpha use = TextureAlpha::Straight) const;

    // Pixels; 1 of an image that cannot be read.
    [[nodiscard]] int width(int texture) const;

    [[nodiscard]] int size() const;
    [[nodiscard]] bool started() const;  // whether OpenImageIO is in use
    [[nodiscard]] std::vector<std::string> warnings() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace eye_render
