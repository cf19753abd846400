// The film: running sums per pixel in double, and pictures made from them on request.
//
// Samples are added one after the other in the order of their numbers, so the sums do not depend
// on threads, tiles or how the samples were cut into slices. A tile is taken out, filled by one
// thread and put back; snapshots may be taken at any time.

#pragma once

#include "render/camera.h"
#include "render/cryptomatte.h"
#include "render/film_layout.h"
#include "render/integrator.h"

#include <array>
#include <cstdint>
#include <mutex>
#include <optional>
#include <span>
#include <vector>

namespace eye_render {

// What leaves the tracer: where the path entered the pupil, its direction in object space, and
// what light it brought. The pixel is the one it was traced for.
struct PathSample {
    int x = 0;
    int y = 0;
    V2d pupil_point_m{0.0};
    double weight = 1.0;
    // What the path says about each colour channel, with a chromatic film: its wavelength lies
    // more in one than in the others. Means are taken channel by channel, so white stays white
    // as soon as every channel has had its share: from four samples on.
    V3d channel_weight{1.0};
    RayFate fate = RayFate::Transmitted;
    PathRadiance light;  // of a lost ray: black and opaque, as the inside of the eye is
    const PassValues* values = nullptr;  // if the layout has any
};

struct PassImage {
    PassRequest pass;
    int width = 0;
    int height = 0;
    std::vector<float> pixels;  // rows bottom-up, channels interleaved
};

// How many rays the eye sent out, by what became of them in it.
struct RayFates {
    std::array<std::uint64_t, ray_fates.size()> count{};

    [[nodiscard]] std::uint64_t& operator[](RayFate fate)
    {
        return count[static_cast<std::size_t>(fate)];
    }
    [[nodiscard]] std::uint64_t operator[](RayFate fate) const
    {
        return count[static_cast<std::size_t>(fate)];
    }
};

class FilmTile {
public:
    void add(const PathSample& sample);
    // Of the chief ray: one value a channel of the layout's.
    void set(int x, int y, std::span<const float> chief);
    [[nodiscard]] const PixelBounds& bounds() const { return bounds_; }

private:
    friend class Film;

    void add(const PassValues& values,
             std::size_t pixel,
             const V3d& channel_weight,
             double weight);

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<float> chief_;
    std::vector<MatteSums> mattes_;  // one a pixel and kind
    RayFates fates_;                 // of the samples added
};

class Film {
public:
    Film(const PixelBounds& bounds, const FilmLayout& layout);

    [[nodiscard]] const PixelBounds& bounds() const { return bounds_; }

    // Tiles out at the same time must not overlap.
    [[nodiscard]] FilmTile take(const PixelBounds& bounds) const;
    void put(const FilmTile& tile);

    // A pixel without samples is black and transparent. The passes are among those that the layout
    // provides for.
    [[nodiscard]] std::vector<PassImage> snapshot(const std::vector<PassRequest>& passes) const;

    [[nodiscard]] RayFates fates() const;

private:
    // Of pixel number `pixel`.
    void write(const PassRequest& request, std::size_t pixel, std::span<float> channels) const;

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<float> chief_;
    std::vector<MatteSums> mattes_;  // one a pixel and kind
    RayFates fates_;
    mutable std::mutex mutex_;
};

}  // namespace eye_render
