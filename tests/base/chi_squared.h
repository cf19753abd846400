// Pearson's chi-squared test of samples against the density they claim.

#pragma once

#include <cmath>
#include <vector>

namespace eye_render::test {

struct ChiSquared {
    double statistic = 0.0;
    double critical = 0.0;  // exceeded with probability `significance` when the density is right
};

// Normal quantile z with P(Z > z) = p, for small p (Abramowitz & Stegun 26.2.23, 4.5e-4).
[[nodiscard]] inline double upper_normal_quantile(double p)
{
    const double t = std::sqrt(-2.0 * std::log(p));
    return t - (2.515517 + t * (0.802853 + t * 0.010328)) /
                   (1.0 + t * (1.432788 + t * (0.189269 + t * 0.001308)));
}

// Cells whose expectation is below 5 are pooled, as the approximation to the chi-squared
// distribution asks. The critical value is Wilson & Hilferty's.
[[nodiscard]] inline ChiSquared chi_squared_test(const std::vector<double>& observed,
                                                 const std::vector<double>& expected,
                                                 double significance)
{
    ChiSquared result;
    double pooled_observed = 0.0;
    double pooled_expected = 0.0;
    int cells = 0;
    const auto add = [&](double o, double e) {
        result.statistic += (o - e) * (o - e) / e;
        ++cells;
    };
    for (std::size_t i = 0; i < observed.size(); ++i) {
        if (expected[i] < 5.0) {
            pooled_observed += observed[i];
            pooled_expected += expected[i];
        } else {
            add(observed[i], expected[i]);
        }
    }
    if (pooled_expected > 0.0) {
        add(pooled_observed, pooled_expected);
    } else if (pooled_observed > 0.0) {
        result.statistic = INFINITY;  // a sample where the density is zero
    }
    const double freedom = cells - 1;
    const double c = 2.0 / (9.0 * freedom);
    result.critical =
        freedom * std::pow(1.0 - c + upper_normal_quantile(significance) * std::sqrt(c), 3);
    return result;
}

}  // namespace eye_render::test
