#include "render/pixel_filter.h"

#include "base/error.h"
#include "base/units.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

namespace {

// A filter along one axis: how far it reaches, and the share of it below x.
struct FilterShape {
    double radius_px;
    double (*cdf)(double x_over_radius);  // of -1 to 1
};

double box_cdf(double x) { return 0.5 + 0.5 * x; }

// exp(-18 x^2), cut off at 1: of 1.5 widths to each side, exp(-8 (1.5 x)^2).
double gaussian_cdf(double x)
{
    const double root = std::sqrt(18.0);
    return 0.5 + 0.5 * std::erf(root * x) / std::erf(root);
}

// The primitive of 0.35875 + 0.48829 cos pi x + 0.14128 cos 2 pi x + 0.01168 cos 3 pi x.
double blackman_harris_cdf(double x)
{
    return 0.5 + 0.5 * x +
           (0.48829 * std::sin(pi * x) + 0.14128 * std::sin(2.0 * pi * x) / 2.0 +
            0.01168 * std::sin(3.0 * pi * x) / 3.0) /
               (2.0 * pi * 0.35875);
}

FilterShape shape_of(PixelFilterKind kind, double width_px)
{
    switch (kind) {
    case PixelFilterKind::Box: return {0.5, box_cdf};
    case PixelFilterKind::Gaussian: return {1.5 * width_px, gaussian_cdf};
    case PixelFilterKind::BlackmanHarris: break;
    }
    return {width_px, blackman_harris_cdf};
}

}  // namespace

std::string_view to_string(PixelFilterKind kind)
{
    switch (kind) {
    case PixelFilterKind::Box: return "BOX";
    case PixelFilterKind::Gaussian: return "GAUSSIAN";
    case PixelFilterKind::BlackmanHarris: break;
    }
    return "BLACKMAN_HARRIS";
}

PixelFilter::PixelFilter(PixelFilterKind kind, double width_px)
{
    require_range("filter_width_px", width_px, 0.001, 10.0, "px");
    const FilterShape shape = shape_of(kind, width_px);
    for (std::size_t i = 0; i <= resolution; ++i) {
        const double target = static_cast<double>(i) / static_cast<double>(resolution);
        double low = -1.0;
        double high = 1.0;
        // Bisection down to the spacing of doubles: filters are positive, so their integral rises.
        for (int step = 0; step < 60; ++step) {
            const double middle = 0.5 * (low + high);
            (shape.cdf(middle) < target ? low : high) = middle;
        }
        inverse_cdf_[i] = low * shape.radius_px;
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
