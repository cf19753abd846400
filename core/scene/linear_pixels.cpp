#include "scene/linear_pixels.h"

#include "scene/texel.h"
#include "scene/texture_cache.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <array>
#include <cmath>

namespace eye_render {

namespace {

// Where pixel `i` of `count` begins among `size` pixels.
int first_of(int i, int count, int size)
{
    return static_cast<int>(std::int64_t(i) * size / count);
}

Color3f linear_color(const float* texel, int channels, Colorspace colorspace)
{
    std::array<float, 4> rgba{};
    expand_to_rgba(texel, channels, 1.0f, rgba.data(), 1);
    const Color3f encoded(rgba[0], rgba[1], rgba[2]);
    return colorspace == Colorspace::Srgb ? linear_from_srgb(encoded) : encoded;
}

}  // namespace

LinearPixels shrink_image(const TextureCache& cache,
                          const CachedImage& image,
                          Colorspace colorspace,
                          int max_width)
{
    LinearPixels result;
    result.width = std::clamp(max_width, 1, image.width);
    const double height = double(image.height) * result.width / image.width;
    result.height = std::clamp(static_cast<int>(std::lround(height)), 1, image.height);
    const auto width = static_cast<std::size_t>(result.width);
    result.rgb.assign(width * static_cast<std::size_t>(result.height), Color3f(0.0f));
    // Each row of the result is the mean of a band of whole rows of the image.
    const auto shrink_row = [&](int row) {
        const int y0 = first_of(row, result.height, image.height);
        const int y1 = first_of(row + 1, result.height, image.height);
        const std::vector<float> band = cache.rows(image, y0, y1);
        if (band.empty()) {
            return;
        }
        Color3f* out = &result.rgb[static_cast<std::size_t>(result.height - 1 - row) * width];
        for (int x = 0; x < result.width; ++x) {
            const int x0 = first_of(x, result.width, image.width);
            const int x1 = first_of(x + 1, result.width, image.width);
            Color3f sum(0.0f);
            for (int y = 0; y < y1 - y0; ++y) {
                for (int i = x0; i < x1; ++i) {
                    const auto pixel = std::ptrdiff_t(y) * image.width + i;
                    sum += linear_color(band.data() + pixel * image.channels, image.channels,
                                        colorspace);
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

}  // namespace eye_render
