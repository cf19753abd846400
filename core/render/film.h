// The film: running sums per pixel in double, and pictures made from them on request.
//
// Samples are added one after the other in the order of their numbers, so the sums do not depend
// on threads, tiles or how the samples were cut into slices. A tile is taken out, filled by one
// thread and put back; snapshots may be taken at any time.

#pragma once

#include "render/camera.h"
#include "render/integrator.h"
#include "render/pass_layout.h"

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
    V2d slope{0.0};
    double weight = 1.0;
    // What the path says about each colour channel, with a chromatic film: its wavelength lies
    // more in one than in the others. Means are taken channel by channel, so white stays white
    // as soon as every channel has had its share: from four samples on.
    V3d channel_weight{1.0};
    RayFate fate = RayFate::Transmitted;
    PathRadiance light;  // of a lost ray: black and opaque, as the inside of the eye is
    std::span<const float> values{};  // of the layout's passes; none of a lost ray
};

struct PassImage {
    Pass pass;
    int width = 0;
    int height = 0;
    std::vector<float> pixels;  // rows bottom-up, channels interleaved
};

// What the film keeps for a pixel: only what some pass of the plan needs is allocated. And what
// becomes of light that the eye loses.
struct FilmLayout {
    PassLayout passes{};
    bool chromatic = false;
    // Nothing: the picture keeps its brightness, as seeing does; lost rays are counted and left
    // out of the means. A number: what part of the light counts; the picture darkens to it, and
    // by the lost rays, which are black.
    std::optional<double> efficiency{};
    double exposure = 1.0;  // a factor of all light in the picture

    // What the means of light are multiplied by.
    [[nodiscard]] double light_scale() const { return exposure * efficiency.value_or(1.0); }

    // Sums a pixel: weight, RGB, alpha, the channels of the passes, and with a chromatic film the
    // channels' weights.
    [[nodiscard]] std::size_t stride() const { return channel_weights() + (chromatic ? 3 : 0); }
    [[nodiscard]] std::size_t channel_weights() const { return 5 + passes.channels(); }
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

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<float> chief_;
    RayFates fates_;  // of the samples added
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
    [[nodiscard]] std::vector<PassImage> snapshot(std::span<const Pass> passes) const;

    [[nodiscard]] RayFates fates() const;

private:
    void write(std::vector<float>& pixels, Pass pass) const;
    // The mean over the samples of channel `channel` of the pass, of the pixel whose sums begin at
    // `sums`.
    [[nodiscard]] double mean(const double* sums, Pass pass, std::size_t channel) const;

    // Where a pixel keeps the sum of the weights that went into a channel of Combined.
    [[nodiscard]] std::size_t weight_of(std::size_t channel) const;

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<float> chief_;
    RayFates fates_;
    mutable std::mutex mutex_;
};

}  // namespace eye_render
