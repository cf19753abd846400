// Means with their standard errors, for tests against derived answers.

#pragma once

#include "render/integrator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace eye_render::test {

struct Estimate {
    double mean = 0.0;
    double standard_error = 0.0;
};

// The mean of `count` calls of value(i).
template <typename Value>
[[nodiscard]] Estimate mean_of(int count, Value&& value)
{
    double sum = 0.0;
    double sum_of_squares = 0.0;
    for (int i = 0; i < count; ++i) {
        const double x = value(i);
        sum += x;
        sum_of_squares += x * x;
    }
    const double mean = sum / count;
    const double variance = std::max(0.0, sum_of_squares / count - mean * mean);
    return {mean, std::sqrt(variance / count)};
}

// The random numbers of the i-th of independent paths.
[[nodiscard]] inline SampleSequence sequence_of(int i, std::uint64_t seed = 7)
{
    return {sobol_key(seed, static_cast<std::uint64_t>(i)), 0};
}

// Radiance along `ray`, red channel, over `count` paths.
[[nodiscard]] inline Estimate estimate(const Scene& scene,
                                       const IntegratorSettings& settings,
                                       const Ray& ray,
                                       int count)
{
    return mean_of(count, [&](int i) {
        SampleSequence sequence = sequence_of(i);
        return static_cast<double>(trace_path(scene, settings, ray, sequence).radiance.x);
    });
}

// Four standard errors: one false alarm in 16,000 runs, and the seed is fixed. The absolute part
// is float rounding of a sum of this size.
inline void expect_matches(const Estimate& found, double expected)
{
    EXPECT_NEAR(found.mean, expected, 4.0 * found.standard_error + 2e-5 * expected)
        << "standard error " << found.standard_error;
}

}  // namespace eye_render::test
