// The text of a refused number: name, value, unit and what is allowed, as the user sees it.

#pragma once

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace eye_render {

inline constexpr int usual_digits = 6;

// Whole numbers below a thousand million in full, others rounded: 190, 16777216, -2.5, 1e+12, nan.
[[nodiscard]] inline std::string number_text(double value, int digits = usual_digits)
{
    std::ostringstream text;
    if (std::abs(value) < 1e9 && value == std::trunc(value)) {
        text << std::fixed << std::setprecision(0) << value;
    } else {
        text << std::setprecision(digits) << value;
    }
    return text.str();
}

// Throws std::invalid_argument, "sphere_d is 45 D; expected -30 to 30 D", unless
// minimum <= value <= maximum. NaN is in no range. `unit` may be empty.
inline void require_range(std::string_view name,
                          double value,
                          double minimum,
                          double maximum,
                          std::string_view unit)
{
    if (value >= minimum && value <= maximum) {
        return;
    }
    // As many digits as tell the value from the bound that it is beyond.
    int digits = usual_digits;
    while (digits < std::numeric_limits<double>::max_digits10 &&
           (number_text(value, digits) == number_text(minimum, digits) ||
            number_text(value, digits) == number_text(maximum, digits))) {
        ++digits;
    }
    const std::string tail = unit.empty() ? std::string() : std::string(" ").append(unit);
    throw std::invalid_argument(std::string(name) + " is " + number_text(value, digits) + tail +
                                "; expected " + number_text(minimum, digits) + " to " +
                                number_text(maximum, digits) + tail);
}

}  // namespace eye_render
