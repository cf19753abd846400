// The pixel reconstruction filter, sampled instead of splatted: every sample belongs to one pixel
// with weight 1 and is displaced by the filter's own distribution. So a pixel depends on no other
// pixel's samples, and tiles need no overlap.

#pragma once

#include "base/vector.h"

#include <array>
#include <string_view>

namespace eye_render {

enum class PixelFilterKind { Box, Gaussian, BlackmanHarris };

inline constexpr std::array pixel_filter_kinds{PixelFilterKind::Box, PixelFilterKind::Gaussian,
                                               PixelFilterKind::BlackmanHarris};

// "BOX", "GAUSSIAN", "BLACKMAN_HARRIS".
[[nodiscard]] std::string_view to_string(PixelFilterKind kind);

// Separable. With w for `width_px` and x the distance from the pixel's centre along an axis, as in
// Cycles:
//   Box             1 within half a pixel, whatever w
//   Gaussian        exp(-8 x^2 / w^2) to 1.5 w
//   BlackmanHarris  the window of Harris 1978, 4 terms, to w
class PixelFilter {
public:
    // Throws std::invalid_argument unless width_px is 0.001 to 10.
    PixelFilter(PixelFilterKind kind, double width_px);

    // Displacement from the pixel's centre, in pixels; density per square pixel is the filter.
    [[nodiscard]] V2d sample(const V2f& u) const;

private:
    static constexpr std::size_t resolution = 1024;

    [[nodiscard]] double sample_axis(float u) const;

    std::array<double, resolution + 1> inverse_cdf_;
};

}  // namespace eye_render
