// The grammar over the tokens: ["Rx"] [eye] sphere [cylinder axis] {prism} [add] {prism}, all or
// its tail bracketed.

#include "optics/prescription_text.h"

#include "base/error.h"
#include "optics/prescription_tokens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <vector>

namespace eye_render {

namespace {

using Kind = PrescriptionToken::Kind;

constexpr std::string_view example = "-2.00DS -0.75DC 160A";

[[noreturn]] void fail_syntax(const std::string& sentence)
{
    throw PrescriptionError(PrescriptionErrorCode::Syntax,
                            sentence + "; write for example " + std::string(example));
}

std::string as_typed(const PrescriptionToken& token)
{
    return token.sign != 0 ? token.sign + token.text : token.text;
}

// A power is refused beyond its range, and when it looks like one with an implied decimal point:
// "-075" is how some write -0.75, and nobody writes so of 75 dioptres.
double checked_power(std::string_view name,
                     const PrescriptionToken& number,
                     double minimum,
                     double maximum,
                     std::string_view unit = "D")
{
    const bool implied_point =
        number.text.size() > 2 && number.text.find('.') == std::string::npos;
    if (implied_point || !(number.value >= minimum && number.value <= maximum)) {
        throw PrescriptionError(PrescriptionErrorCode::PowerRange,
                                std::string(name) + " is " + as_typed(number) + ' ' +
                                    std::string(unit) + "; expected " + number_text(minimum) +
                                    " to " + number_text(maximum) + ' ' + std::string(unit) +
                                    ", with its decimal point, as in -2.00");
    }
    return number.value;
}

class Parser {
public:
    explicit Parser(std::string_view text) : tokens_(prescription_tokens(text)) {}

    Prescription parse()
    {
        int open_brackets = take_mark("(") ? 1 : 0;
        take_word({"rx"});
        Prescription rx{.eye = take_eye()};
        open_brackets += take_mark("(") ? 1 : 0;
        rx.sphere_d = take_sphere();
        const bool announced = take_mark("/");
        if (!announced || !take_word({"ds", "sph", "sphere"})) {
            take_cylinder(rx, announced);
        }
        open_brackets -= take_closing(open_brackets);
        take_prisms(rx);
        if (take_word({"add"})) {
            rx.add_d = checked_power("add_d", take_number("an addition"), 0.0, max_add_d);
            take_word({"d", "ds", "dpt"});
        }
        take_prisms(rx);
        for (const double sum_pd : {rx.base_in_pd, rx.base_up_pd}) {
            if (std::abs(sum_pd) > max_prism_pd) {
                throw PrescriptionError(PrescriptionErrorCode::PowerRange,
                                        "prism is " + number_text(std::abs(sum_pd)) +
                                            " prism dioptres in all; expected 0 to " +
                                            number_text(max_prism_pd) + " prism dioptres");
            }
        }
        if (take_closing(open_brackets) < open_brackets) {
            fail_syntax("a bracket is not closed");
        }
        if (next_ < tokens_.size()) {
            fail_syntax("cannot read '" + as_typed(tokens_[next_]) +
                        "' at the end of the prescription");
        }
        return rx;
    }

private:
    // Any number of prisms, such as "2\u0394 BU 1.5\u0394 BI"; those of one direction add up.
    void take_prisms(Prescription& rx)
    {
        while (next_is_prism()) {
            const PrescriptionToken& number = take_number("a prism");
            if (number.sign != 0) {
                fail_syntax("a prism has a base, not a sign: " + as_typed(number));
            }
            const double power_pd =
                checked_power("prism", number, 0.0, max_prism_pd, "prism dioptres");
            if (!take_mark("\u0394") && !take_mark("^")) {
                take_word({"pd", "prism"});
            }
            take_word({"base"});
            if (take_word({"bu", "up"})) {
                rx.base_up_pd += power_pd;
            } else if (take_word({"bd", "down"})) {
                rx.base_up_pd -= power_pd;
            } else if (take_word({"bi", "in"})) {
                rx.base_in_pd += power_pd;
            } else if (take_word({"bo", "out"})) {
                rx.base_in_pd -= power_pd;
            } else {
                fail_syntax("a prism needs its base: BU, BD, BI or BO");
            }
        }
    }

    [[nodiscard]] bool next_is_prism() const
    {
        constexpr std::array<std::string_view, 9> followers{"\u0394", "^",  "pd", "prism", "base",
                                                            "bu",     "bd", "bi", "bo"};
        return next_is(Kind::Number) && next_ + 1 < tokens_.size() &&
               std::find(followers.begin(), followers.end(), tokens_[next_ + 1].text) !=
                   followers.end();
    }

    EyeSide take_eye()
    {
        if (take_word({"od", "re", "r", "right"})) {
            return EyeSide::Right;
        }
        if (take_word({"os", "le", "l", "left"})) {
            return EyeSide::Left;
        }
        if (take_word({"ou", "be", "both"})) {
            return EyeSide::Both;
        }
        return EyeSide::Unspecified;
    }

    double take_sphere()
    {
        take_word({"sph", "sphere", "s"});
        if (take_word({"plano", "pl"})) {
            take_word({"ds", "sph", "sphere"});
            return 0.0;
        }
        const double sphere_d =
            checked_power("sphere_d", take_number("a sphere"), -max_sphere_d, max_sphere_d);
        take_word({"ds", "d", "dpt", "s", "sph", "sphere"});
        return sphere_d;
    }

    // Cylinder and axis; nothing at all unless a slash has announced them.
    void take_cylinder(Prescription& rx, bool announced)
    {
        const bool labelled = take_word({"cyl", "cylinder", "c"});
        if (!announced && !labelled && (!next_is(Kind::Number) || next_is_prism())) {
            return;
        }
        const PrescriptionToken& cylinder = take_number("a cylinder");
        // Nothing after a slash can only be no cylinder; elsewhere it may be a slip.
        const bool surely_none = announced && cylinder.value == 0.0;
        if (cylinder.sign == 0 && !surely_none) {
            fail_syntax("the cylinder " + cylinder.text + " needs its sign, + or -");
        }
        const double cylinder_d =
            checked_power("cylinder_d", cylinder, -max_cylinder_d, max_cylinder_d);
        take_word({"dc", "d", "dpt", "c", "cyl"});
        take_mark("/");
        const bool has_axis = take_axis(rx);
        if (cylinder_d == 0.0) {
            rx.axis_deg = Prescription{}.axis_deg;
            return;
        }
        if (!has_axis) {
            throw PrescriptionError(PrescriptionErrorCode::AxisMissing,
                                    "the cylinder " + as_typed(cylinder) +
                                        " needs its axis, 0 to 180; write for example " +
                                        std::string(example));
        }
        rx.cylinder_d = cylinder_d;
    }

    bool take_axis(Prescription& rx)
    {
        const bool marked = take_word({"x", "ax", "axis"}) || take_mark("@") || take_mark("*");
        if (!marked && !next_is(Kind::Number)) {
            return false;
        }
        const PrescriptionToken& axis = take_number("an axis");
        const bool suffixed = take_word({"a", "deg", "degrees"}) || take_mark("\u00b0");
        // Without any mark only a whole number is surely an axis: 2.00 could be an addition.
        if (!marked && !suffixed && (axis.sign != 0 || axis.text.find('.') != std::string::npos)) {
            fail_syntax("cannot tell whether " + axis.text + " is an axis");
        }
        if (!(axis.value >= 0.0 && axis.value <= 180.0)) {
            throw PrescriptionError(PrescriptionErrorCode::AxisRange, "axis_deg is " +
                                                                          number_text(axis.value) +
                                                                          "; expected 0 to 180");
        }
        rx.axis_deg = normalized_axis_deg(axis.value);
        return true;
    }

    // How many of the open brackets close here.
    int take_closing(int open_brackets)
    {
        int closed = 0;
        while (closed < open_brackets && take_mark(")")) {
            ++closed;
        }
        return closed;
    }

    [[nodiscard]] bool next_is(Kind kind) const
    {
        return next_ < tokens_.size() && tokens_[next_].kind == kind;
    }

    bool take_word(std::initializer_list<std::string_view> words)
    {
        const bool found = next_is(Kind::Word) && std::find(words.begin(), words.end(),
                                                            tokens_[next_].text) != words.end();
        next_ += found ? 1 : 0;
        return found;
    }

    bool take_mark(std::string_view mark)
    {
        const bool found = next_is(Kind::Mark) && tokens_[next_].text == mark;
        next_ += found ? 1 : 0;
        return found;
    }

    const PrescriptionToken& take_number(const std::string& what)
    {
        if (!next_is(Kind::Number)) {
            fail_syntax(next_ < tokens_.size()
                            ? "cannot read '" + as_typed(tokens_[next_]) + "' as " + what
                            : what + " is missing at the end of the prescription");
        }
        return tokens_[next_++];
    }

    std::vector<PrescriptionToken> tokens_;
    std::size_t next_ = 0;
};

}  // namespace

std::string_view to_string(PrescriptionErrorCode code)
{
    switch (code) {
    case PrescriptionErrorCode::Syntax: return "syntax";
    case PrescriptionErrorCode::AxisMissing: return "axis_missing";
    case PrescriptionErrorCode::AxisRange: return "axis_range";
    case PrescriptionErrorCode::PowerRange: return "power_range";
    }
    return "";
}

Prescription parse_prescription(std::string_view text) { return Parser(text).parse(); }

}  // namespace eye_render
