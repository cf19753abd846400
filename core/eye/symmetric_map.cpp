// By least squares on points of one quadrant.

#include "eye/symmetric_map.h"

#include "optics/least_squares.h"

#include <vector>

namespace eye_render {

std::optional<SymmetricMap> SymmetricMap::fitted(const std::function<Sought(const V2d&)>& function,
                                                 double radius)
{
    constexpr std::size_t radii = degree + 4;
    constexpr std::size_t angles = degree + 3;
    constexpr std::size_t terms = monomials_of_two(degree);

    SymmetricMap map;
    map.per_radius_ = 1.0 / radius;
    std::vector<double> x_rows;
    std::vector<double> y_rows;
    std::vector<double> x_values;
    std::vector<double> y_values;
    for (std::size_t i = 0; i < radii; ++i) {
        for (std::size_t j = 0; j < angles; ++j) {
            const V2d p = fitting_point(fitting_radius(i, radii), 0.5 * pi, j, angles);
            const Sought image = function(p * radius);
            if (image.fate != TraceFate::Passed) return std::nullopt;
            for (const double m : monomials<degree>(p.x * p.x, p.y * p.y)) {
                x_rows.push_back(p.x * m);
                y_rows.push_back(p.y * m);
            }
            x_values.push_back(image.value.x);
            y_values.push_back(image.value.y);
        }
    }
    const auto x = least_squares(terms, std::move(x_rows), std::move(x_values));
    const auto y = least_squares(terms, std::move(y_rows), std::move(y_values));
    for (std::size_t i = 0; i < terms; ++i) map.coefficients_[i] = {x[i], y[i]};
    return map;
}

}  // namespace eye_render
