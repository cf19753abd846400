// The text of an IESNA LM-63 file: what stands after the line TILT=, numbers in free form.

#include "shading/ies_profile.h"
#include "shading/ies_table.h"

#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>

namespace eye_render {

namespace {

// Numbers separated by spaces, line ends or commas.
class Numbers {
public:
    explicit Numbers(std::string_view rest) : rest_(rest) {}

    double next(const char* what)
    {
        const std::size_t begin = rest_.find_first_not_of(separators);
        if (begin == std::string_view::npos) {
            throw std::invalid_argument(std::string("IES profile: it ends before the ") + what);
        }
        rest_.remove_prefix(begin + (rest_[begin] == '+' ? 1 : 0));
        double value = 0.0;
        const auto [end, error] =
            std::from_chars(rest_.data(), rest_.data() + rest_.size(), value);
        if (error != std::errc() || !std::isfinite(value)) {
            const std::string word(rest_.substr(0, rest_.find_first_of(separators)));
            throw std::invalid_argument(std::string("IES profile: the ") + what + " is '" + word +
                                        "'; expected a number");
        }
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return value;
    }

    std::size_t next_count(const char* what)
    {
        constexpr double most = 100000.0;
        const double value = next(what);
        if (!(value >= 1.0 && value <= most)) {
            throw std::invalid_argument(std::string("IES profile: the ") + what + " is " +
                                        std::to_string(value) + "; expected 1 to 100000");
        }
        return static_cast<std::size_t>(value);
    }

    std::vector<double> next_many(std::size_t count, const char* what)
    {
        std::vector<double> values;
        for (std::size_t i = 0; i < count; ++i) {
            values.push_back(next(what));
        }
        return values;
    }

private:
    static constexpr std::string_view separators = " \t\r\n\f\v,";

    std::string_view rest_;
};

[[nodiscard]] Numbers numbers_of(std::string_view text)
{
    constexpr std::string_view keyword = "TILT=";
    std::size_t tilt = text.find(keyword);
    while (tilt != std::string_view::npos && tilt > 0 && text[tilt - 1] != '\n') {
        tilt = text.find(keyword, tilt + 1);
    }
    if (tilt == std::string_view::npos) {
        throw std::invalid_argument("IES profile: it has no line that begins with TILT=");
    }
    const std::string_view line = text.substr(tilt, text.find('\n', tilt) - tilt);
    Numbers numbers(text.substr(tilt + line.size()));
    if (line.substr(keyword.size()).starts_with("INCLUDE")) {
        // How the lamp dims when it is tilted: nothing that a picture shows.
        static_cast<void>(numbers.next("geometry of the lamp"));
        const std::size_t angles = numbers.next_count("number of tilt angles");
        static_cast<void>(numbers.next_many(2 * angles, "tilt angles and factors"));
    }
    return numbers;
}

[[nodiscard]] IesTable read(std::string_view text)
{
    Numbers numbers = numbers_of(text);
    static_cast<void>(numbers.next("number of lamps"));
    static_cast<void>(numbers.next("lumens per lamp"));
    double factor = watts_per_candela * numbers.next("candela multiplier");
    const std::size_t vertical = numbers.next_count("number of vertical angles");
    const std::size_t horizontal = numbers.next_count("number of horizontal angles");
    const int type = static_cast<int>(numbers.next("photometric type"));
    if (type < 1 || type > 3) {
        throw std::invalid_argument("IES profile: the photometric type is " +
                                    std::to_string(type) + "; expected 1, 2 or 3");
    }
    static_cast<void>(numbers.next_many(4, "units and size of the opening"));
    factor *= numbers.next("ballast factor");
    factor *= numbers.next("ballast-lamp photometric factor");
    static_cast<void>(numbers.next("input watts"));

    IesTable table{.vertical_deg = numbers.next_many(vertical, "vertical angles")};
    table.horizontal_deg = numbers.next_many(horizontal, "horizontal angles");
    for (std::size_t row = 0; row < horizontal; ++row) {
        table.watts.push_back(numbers.next_many(vertical, "candela values"));
        for (double& value : table.watts.back()) {
            value *= factor;
        }
    }
    switch (type) {
    case 1: arrange_type_c(table); break;
    case 2: arrange_type_b(table); break;
    default: arrange_type_a(table); break;
    }
    return table;
}

[[nodiscard]] std::vector<float> in_radians(const std::vector<double>& angles_deg)
{
    std::vector<float> angles;
    angles.reserve(angles_deg.size());
    for (const double angle : angles_deg) {
        angles.push_back(static_cast<float>(angle * std::numbers::pi / 180.0));
    }
    return angles;
}

}  // namespace

IesProfile parse_ies(std::string_view text)
{
    const IesTable table = read(text);
    std::vector<float> watts;
    for (const std::vector<double>& row : table.watts) {
        watts.insert(watts.end(), row.begin(), row.end());
    }
    return {in_radians(table.horizontal_deg), in_radians(table.vertical_deg), std::move(watts)};
}

}  // namespace eye_render
