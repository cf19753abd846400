// What the sums of one pixel say: the passes that are means of samples, or made of such means.

#pragma once

#include "render/film_layout.h"
#include "render/shadow_catcher.h"

#include <span>

namespace eye_render {

class PixelMeans {
public:
    // A pixel without samples is black and transparent.
    PixelMeans(const FilmLayout& layout, const double* sums) : layout_(layout), sums_(sums) {}

    // Fills the channels of a pass that the layout provides for, neither chief nor coverage.
    void write(const PassRequest& request, std::span<float> channels) const;

    // Of all samples, never zero.
    [[nodiscard]] double weight() const { return divisor(sums_[FilmLayout::weight]); }

private:
    // Without samples every sum is 0, and so is every mean.
    static double divisor(double weight) { return weight > 0.0 ? weight : 1.0; }

    [[nodiscard]] double value(const PassRequest& request, std::size_t channel) const;
    [[nodiscard]] double mean(const PassRequest& request, std::size_t channel) const;
    // Of sum number `sum`, for channel `channel` of a colour.
    [[nodiscard]] double light(std::size_t sum, std::size_t channel) const;
    [[nodiscard]] double sample_weight(std::size_t channel) const;
    [[nodiscard]] double combined(std::size_t channel) const;
    // Of the sum of one of the alphas.
    [[nodiscard]] double coverage(std::size_t sum) const;
    [[nodiscard]] CaughtLight caught() const;

    const FilmLayout& layout_;
    const double* sums_;
};

}  // namespace eye_render
