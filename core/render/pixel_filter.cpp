#include "render/pixel_filter.h"

#include "base/error.h"
#include "base/units.h"

#include <cmath>

namespace eye_render {

namespace {

// Integral of the window from -1/2 to x, x in window widths, over its whole: the primitive of
// 0.35875 + 0.48829 cos 2 pi x + 0.14128 cos 4 pi x + 0.01168 cos 6 pi x.
double blackman_harris_cdf(double x)
{
    return 0.5 + x +
           (0.48829 * std::sin(2.0 * pi * x) / (2.0 * pi) +
            0.14128 * std::sin(4.0 * pi * x) / (4.0 * pi) +
            0.01168 * std::sin(6.0 * pi * x) / (6.0 * pi)) /
               0.35875;
}

}  // namespace

PixelFilter::PixelFilter(double width_px)
{
    require_range("filter_width_px", width_px, 0.01, 10.0, "px");
    for (std::size_t i = 0; i <= resolution; ++i) {
        const double target = static_cast<double>(i) / static_cast<double>(resolution);
        double low = -0.5;
        double high = 0.5;
        // Bisection down to the spacing of doubles: the window is positive, so its integral rises.
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            (blackman_harris_cdf(middle) < target ? low : high) = middle;
        }
        inverse_cdf_[i] = 2.0 * low * width_px;
    }
}

double PixelFilter::sample_axis(float u) const
{
    const double x = static_cast<double>(u) * static_cast<double>(resolution);
    const auto cell = std::min(static_cast<std::size_t>(x), resolution - 1);
    const double fraction = x - static_cast<double>(cell);
    return inverse_cdf_[cell] * (1.0 - fraction) + inverse_cdf_[cell + 1] * fraction;
}

V2d PixelFilter::sample(const V2f& u) const { return {sample_axis(u.x), sample_axis(u.y)}; }

}  // namespace eye_render
