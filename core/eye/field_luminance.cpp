// Gaussian-weighted mean luminance, and the solid angle of a picture.

#include "eye/field_luminance.h"

#include "base/error.h"
#include "base/units.h"

#include <cmath>
#include <vector>

namespace eye_render {

namespace {

// The Gaussian along one side of the picture, at the pixels' centres. Scaled to 1 at the most
// central pixel, so that no sigma is so small that every weight vanishes.
std::vector<double> side_weights(std::size_t count, double sigma)
{
    const auto position = [count](std::size_t i) {
        return 2.0 * (static_cast<double>(i) + 0.5) / static_cast<double>(count) - 1.0;
    };
    const double nearest = position(count / 2);
    std::vector<double> weights(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double a = position(i);
        weights[i] = std::exp(-0.5 * (a - nearest) * (a + nearest) / (sigma * sigma));
    }
    return weights;
}

void require_positive(std::string_view name, double value)
{
    if (!(value > 0.0)) {
        throw std::invalid_argument(std::string(name) + " is " + number_text(value) +
                                    "; expected more than 0");
    }
}

// Solid angle, in steradians, of the rectangle between the axis and the corner (x, y).
double corner_solid_angle(double x, double y)
{
    return std::atan2(x * y, std::sqrt(1.0 + x * x + y * y));
}

}  // namespace

double field_luminance_cd_m2(std::span<const Color3f> pixels,
                             std::size_t width,
                             const FieldLuminanceOptions& options)
{
    require_positive("luminance_sigma", options.sigma);
    require_positive("cd_m2_per_unit", options.cd_m2_per_unit);
    if (pixels.empty() || width == 0 || pixels.size() % width != 0) {
        throw std::invalid_argument("the luminance of " + std::to_string(pixels.size()) +
                                    " pixels in rows of " + std::to_string(width) +
                                    " cannot be taken");
    }
    const std::size_t height = pixels.size() / width;
    const std::vector<double> column_weights = side_weights(width, options.sigma);
    const std::vector<double> row_weights = side_weights(height, options.sigma);
    const V3d& rgb = options.weights;
    double weighted = 0.0;
    double total_weight = 0.0;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const double value = rgb.dot(V3d(pixels[y * width + x]));
            if (std::isfinite(value)) {
                const double weight = column_weights[x] * row_weights[y];
                weighted += weight * value;
                total_weight += weight;
            }
        }
    }
    return total_weight > 0.0 ? options.cd_m2_per_unit * weighted / total_weight : 0.0;
}

double field_area_deg2(const SlopeWindow& window)
{
    const double steradians = corner_solid_angle(window.right, window.top) -
                              corner_solid_angle(window.left, window.top) -
                              corner_solid_angle(window.right, window.bottom) +
                              corner_solid_angle(window.left, window.bottom);
    return std::abs(steradians) * deg_from_rad(1.0) * deg_from_rad(1.0);
}

}  // namespace eye_render
