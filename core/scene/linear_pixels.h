// A small linear copy of an image, for tables.

#pragma once

#include "base/vector.h"
#include "scene/texture_options.h"

#include <vector>

namespace eye_render {

struct CachedImage;
class TextureCache;

// Linear Rec. 709, rows bottom-up.
struct LinearPixels {
    int width = 0;
    int height = 0;
    std::vector<Color3f> rgb;
};

// The image shrunk by box filtering to at most `max_width` pixels wide, aspect kept. Rows that
// cannot be read are black.
[[nodiscard]] LinearPixels shrink_image(const TextureCache& cache,
                                        const CachedImage& image,
                                        Colorspace colorspace,
                                        int max_width);

}  // namespace eye_render
