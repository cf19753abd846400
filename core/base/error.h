// The text of a refused number: name, value, unit and what is allowed, as the user sees it.

#pragma once

#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

namespace eye_render {

// The shortest usual form: 190, -2.5, 1e+07, nan.
[[nodiscard]] inline std::string number_text(double value)
{
    std::ostringstream text;
    text << value;
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
    const std::string tail = unit.empty() ? std::string() : std::string(" ").append(unit);
    throw std::invalid_argument(std::string(name) + " is " + number_text(value) + tail +
                                "; expected " + number_text(minimum) + " to " +
                                number_text(maximum) + tail);
}

}  // namespace eye_render
