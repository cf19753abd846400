// The film: running sums per pixel in double, and pictures made from them on request.
//
// Samples are added one after the other in the order of their numbers, so the sums do not depend
// on threads, tiles or how the samples were cut into slices. A tile is taken out, filled by one
// thread and put back; snapshots may be taken at any time.

#pragma once

#include "render/camera.h"
#include "render/integrator.h"
#include "render/passes.h"

#include <mutex>
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
    PathRadiance light;
};

// What the ray through the centres of pixel and pupil met, for the passes that are not means.
struct ChiefSample {
    float depth = background_depth;
    float defocus_d = 0.0f;
    float blur_arcmin = 0.0f;
};

struct PassImage {
    Pass pass;
    int width = 0;
    int height = 0;
    std::vector<float> pixels;  // rows bottom-up, channels interleaved
};

// What the film keeps for a pixel: only what some pass of the plan needs is allocated.
struct FilmLayout {
    bool first_surface = false;
    bool chief = false;

    // Sums a pixel: weight, RGB, alpha, and on request normal and albedo.
    [[nodiscard]] std::size_t stride() const { return first_surface ? 11 : 5; }
};

class FilmTile {
public:
    void add(const PathSample& sample);
    void set(int x, int y, const ChiefSample& chief);
    [[nodiscard]] const PixelBounds& bounds() const { return bounds_; }

private:
    friend class Film;

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<ChiefSample> chief_;
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

private:
    void write_mean(std::vector<float>& pixels, std::size_t first, std::size_t channels) const;

    PixelBounds bounds_;
    FilmLayout layout_;
    std::vector<double> sums_;
    std::vector<ChiefSample> chief_;
    mutable std::mutex mutex_;
};

}  // namespace eye_render
