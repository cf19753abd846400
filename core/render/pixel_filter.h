// The pixel reconstruction filter, sampled instead of splatted: every sample belongs to one pixel
// with weight 1 and is displaced by the filter's own distribution. So a pixel depends on no other
// pixel's samples, and tiles need no overlap.

#pragma once

#include "base/vector.h"

#include <array>

namespace eye_render {

// Blackman-Harris window (Harris 1978, 4 terms), separable. `width_px` means what it does in
// Cycles: the window reaches that far to each side.
class PixelFilter {
public:
    // Throws std::invalid_argument unless width_px is 0.01 to 10.
    explicit PixelFilter(double width_px);

    // Displacement from the pixel's centre, in pixels; density per square pixel is the filter.
    [[nodiscard]] V2d sample(const V2f& u) const;

private:
    static constexpr std::size_t resolution = 1024;

    [[nodiscard]] double sample_axis(float u) const;

    std::array<double, resolution + 1> inverse_cdf_;
};

}  // namespace eye_render
