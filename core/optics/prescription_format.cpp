// Writes a prescription in the notation that prescription_text.h reads.

#include "optics/prescription_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace eye_render {

namespace {

// The shortest decimal that reads back as `value`, with at least `decimals` decimals.
std::string decimal_text(double value, std::size_t decimals)
{
    // Longer than any number in range: 17 significant digits after the zeros of a denormal.
    std::array<char, 400> buffer{};
    const char* const end =
        std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::fixed).ptr;
    std::string text(buffer.cbegin(), end);
    if (decimals > 0) {
        if (text.find('.') == std::string::npos) {
            text += '.';
        }
        const std::size_t written = text.size() - text.find('.') - 1;
        text.append(decimals - std::min(decimals, written), '0');
    }
    return text;
}

std::string power_text(double power_d)
{
    // Without the comparison a negative zero would keep its sign.
    const std::string digits = decimal_text(power_d == 0.0 ? 0.0 : power_d, 2);
    return power_d > 0.0 ? '+' + digits : digits;
}

}  // namespace

std::string format_prescription(const Prescription& rx)
{
    std::string text;
    switch (rx.eye) {
    case EyeSide::Right: text = "OD "; break;
    case EyeSide::Left: text = "OS "; break;
    case EyeSide::Both: text = "OU "; break;
    case EyeSide::Unspecified: break;
    }
    text += power_text(rx.sphere_d) + "DS";
    if (rx.cylinder_d != 0.0) {
        text += ' ' + power_text(rx.cylinder_d) + "DC " + decimal_text(rx.axis_deg, 0) + "A";
    }
    const auto add_prism = [&text](double power_pd, const char* base, const char* opposite) {
        if (power_pd != 0.0) {
            text += ' ' + decimal_text(std::abs(power_pd), 2) + "\u0394 " +
                    (power_pd > 0.0 ? base : opposite);
        }
    };
    add_prism(rx.base_in_pd, "BI", "BO");
    add_prism(rx.base_up_pd, "BU", "BD");
    if (rx.add_d != 0.0) {
        text += " add " + power_text(rx.add_d);
    }
    return text;
}

}  // namespace eye_render
