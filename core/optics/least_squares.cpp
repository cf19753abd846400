#include "optics/least_squares.h"

#include <algorithm>
#include <cmath>

namespace eye_render {

std::vector<double> least_squares(std::size_t columns,
                                  std::vector<double> rows,
                                  std::vector<double> rhs)
{
    // A column that is this short beside its original length depends on those before it.
    constexpr double dependent = 1e-12;

    const std::size_t count = rhs.size();
    // Column by column, so that the inner loops run through memory in order.
    std::vector<std::vector<double>> q(columns, std::vector<double>(count));
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < columns; ++j) q[j][i] = rows[i * columns + j];
    }
    const auto dot_from = [count](std::size_t first, const auto& a, const auto& b) {
        double sum = 0.0;
        for (std::size_t i = first; i < count; ++i) sum += a[i] * b[i];
        return sum;
    };
    std::vector<double> diagonal(columns, 0.0);
    for (std::size_t k = 0; k < columns; ++k) {
        std::vector<double>& v = q[k];
        const double length = std::sqrt(dot_from(k, v, v));
        if (length <= dependent * std::sqrt(dot_from(0, v, v))) continue;
        diagonal[k] = v[k] > 0.0 ? -length : length;
        v[k] -= diagonal[k];
        const double scale = 2.0 / dot_from(k, v, v);
        const auto reflect = [&](std::vector<double>& x) {
            const double along = scale * dot_from(k, v, x);
            for (std::size_t i = k; i < count; ++i) x[i] -= along * v[i];
        };
        for (std::size_t j = k + 1; j < columns; ++j) reflect(q[j]);
        reflect(rhs);
    }
    std::vector<double> unknowns(columns, 0.0);
    for (std::size_t k = columns; k-- > 0;) {
        if (diagonal[k] == 0.0) continue;
        double rest = rhs[k];
        for (std::size_t j = k + 1; j < columns; ++j) rest -= q[j][k] * unknowns[j];
        unknowns[k] = rest / diagonal[k];
    }
    return unknowns;
}

}  // namespace eye_render
