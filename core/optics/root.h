// The one door to Boost.Math: a root between two arguments, by Alefeld, Potra & Shi 1995 (TOMS
// 748).

#pragma once

#include <boost/math/tools/roots.hpp>

#include <cmath>
#include <cstdint>
#include <optional>

namespace eye_render {

// An argument between `low` and `high` at which the continuous `f` is zero, to the last few bits.
// Nothing when f has the same sign at both ends or is NaN at one of them.
template <typename Function>
[[nodiscard]] std::optional<double> bracketed_root(const Function& f, double low, double high)
{
    const double f_low = f(low);
    const double f_high = f(high);
    if (f_low == 0.0) return low;
    if (f_high == 0.0) return high;
    if (std::isnan(f_low) || std::isnan(f_high)) return std::nullopt;
    if (std::signbit(f_low) == std::signbit(f_high)) return std::nullopt;
    std::uintmax_t evaluations = 100;  // it takes about ten
    const auto bracket = boost::math::tools::toms748_solve(
        f, low, high, f_low, f_high, boost::math::tools::eps_tolerance<double>(), evaluations);
    return 0.5 * (bracket.first + bracket.second);
}

}  // namespace eye_render
