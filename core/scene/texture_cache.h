// The door to OpenImageIO: a private texture system, and the only part of the project that knows
// it.
//
// Files go through its cache as they are. Pictures in memory, and files whose colour is not yet
// multiplied by alpha (PNG), are kept here and reach the cache through an ImageInput of our own:
// whatever the cache evicts, it can read again. Rows are counted from the top, and values are
// encoded as in the file, between 0 and 1 for whole numbers; colour is multiplied by alpha,
// unless it is data.

#pragma once

#include "scene/memory_image.h"
#include "scene/texture_options.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace eye_render {

struct CachedImage {
    int number = 0;
    int width = 0;
    int height = 0;
    int channels = 0;  // that are looked up: 1 to 4
};

class TextureCache {
public:
    TextureCache();
    ~TextureCache();
    TextureCache(const TextureCache&) = delete;
    TextureCache& operator=(const TextureCache&) = delete;

    // Throws std::runtime_error with OpenImageIO's reason for a file that cannot be read.
    [[nodiscard]] CachedImage add_file(const std::string& path, const TextureOptions& options);
    [[nodiscard]] CachedImage add_memory(MemoryImage image, const TextureOptions& options);

    // The image's first channels at (u, v), v = 0 the top; the other entries are zero. Nothing if
    // the file cannot be read any more: `take_error` says why. Safe from any number of threads
    // once everything is added.
    [[nodiscard]] std::optional<std::array<float, 4>> lookup(const CachedImage& image,
                                                             float u,
                                                             float v) const;

    // Why this thread's last lookup failed. Asked again, it is empty.
    [[nodiscard]] std::string take_error() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace eye_render
